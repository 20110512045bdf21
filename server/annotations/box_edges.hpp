// Chooses the edges of the bounding box along which the axes of a picture are drawn.
#pragma once

#include "annotations/camera.hpp"
#include "annotations/overlay.hpp"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ciel::annotations {

struct BoxEdge {
    int axis = 0;
    glm::dvec3 low{}, high{}; // world coordinates of the ends of the edge
    double from = 0, to = 1;  // the visible part, as fractions from low to high
    Place outward;            // unit vector in the picture that is normal to the edge and points away from the box
};

// Projects world coordinates to the picture of a viewpoint. Does not own the viewpoint, which must outlive the
// Projection.
class Projection {
public:
    explicit Projection(const Viewpoint& viewpoint);
    [[nodiscard]] glm::dvec4 clip(const glm::dvec3& world) const;
    [[nodiscard]] Place pixel(const glm::dvec3& world) const; // only for points in front of the eye
    // Returns the part of the line from a to b that is inside the view volume, as fractions: 0 is at a, 1 is at b.
    // Returns nothing if no part is inside.
    [[nodiscard]] std::optional<std::pair<double, double>> part_seen(const glm::dvec3& a, const glm::dvec3& b) const;
    // Returns whether the eye sees the outer side of a face of the box. The face is normal to `axis`. `upper`: true for
    // the face at bounds_max, false for the face at bounds_min.
    [[nodiscard]] bool sees_face(int axis, bool upper) const;
    [[nodiscard]] int upward_axis() const { return upward_axis_; } // axis that is most vertical in the picture

private:
    const Viewpoint& viewpoint_;
    glm::dmat4 matrix_{};
    glm::dvec3 eye_{}, ahead_{}; // position of the eye, and unit vector along the view direction, in world coordinates
    int upward_axis_ = 0;
};

// Returns at most one edge for each axis. Only edges on the silhouette of the box are considered: they neither hide the
// scene nor are hidden by it. The axis that is most vertical in the picture gets its leftmost edge. Each other axis
// gets its lowest edge. Edges shorter than `least` pixels are left out. The result is empty if the eye is inside the
// box.
[[nodiscard]] std::vector<BoxEdge> axis_edges(const Viewpoint& viewpoint, double least);

} // namespace ciel::annotations
