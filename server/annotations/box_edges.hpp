// Chooses the edges of the bounding box along which the axes of a picture are drawn.
#pragma once

#include "annotations/camera.hpp"
#include "annotations/overlay.hpp"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace server::annotations {

struct BoxEdge {
    int axis = 0;
    glm::dvec3 low{}, high{}; // world coordinates of the ends of the edge
    double from = 0, to = 1;  // the visible part, as fractions from low to high
    PicturePoint outward;     // unit vector in the picture that is normal to the edge and points away from the box
};

// Projects world coordinates onto the picture. Does not own the viewpoint, which must outlive the Projection.
class Projection {
public:
    explicit Projection(const Viewpoint& viewpoint);
    [[nodiscard]] glm::dvec4 clip(const glm::dvec3& world) const;
    [[nodiscard]] PicturePoint pixel(const glm::dvec3& world) const; // only for points in front of the eye
    // Returns the part of the line inside the view volume as fractions, 0 at a and 1 at b, or nothing.
    [[nodiscard]] std::optional<std::pair<double, double>> part_seen(const glm::dvec3& a, const glm::dvec3& b) const;
    // Returns whether a face of the bounding box faces the eye. The face is normal to `axis`. `upper`: true for the
    // face at bounds_max, false for the face at bounds_min.
    [[nodiscard]] bool sees_face(int axis, bool upper) const;
    [[nodiscard]] int upward_axis() const { return upward_axis_; } // axis that is most vertical in the picture

private:
    const Viewpoint& viewpoint_;
    glm::dmat4 matrix_{};
    glm::dvec3 eye_{}, ahead_{}; // position of the eye, and unit vector along the view direction, in world coordinates
    int upward_axis_ = 0;
};

// Returns at most one edge for each axis. Only edges on the silhouette of the box are considered. The axis that is most
// vertical in the picture gets its leftmost edge, each other axis its lowest edge. Edges shorter than `least` pixels
// are left out. The result is empty if the eye is inside the box.
[[nodiscard]] std::vector<BoxEdge> axis_edges(const Viewpoint& viewpoint, double least);

} // namespace server::annotations
