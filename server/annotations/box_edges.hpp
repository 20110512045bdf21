// Chooses the edges of a box that carry the axes in a picture.
#pragma once

#include "annotations/camera.hpp"
#include "annotations/overlay.hpp"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ciel::annotations {

struct BoxEdge {
    int axis = 0;
    glm::dvec3 low{}, high{}; // world coordinates of its ends
    double from = 0, to = 1;  // the visible part, as fractions from low to high
    Place outward;            // unit vector in the picture, normal to the edge, away from the box
};

// Projects world coordinates to the picture of a viewpoint. Borrows the viewpoint.
class Projection {
public:
    explicit Projection(const Viewpoint& viewpoint);
    [[nodiscard]] glm::dvec4 clip(const glm::dvec3& world) const;
    [[nodiscard]] Place pixel(const glm::dvec3& world) const; // for points in front of the eye only
    // Returns the part of the line from a to b inside the view volume, as fractions from a to b; nothing if it is
    // outside.
    [[nodiscard]] std::optional<std::pair<double, double>> part_seen(const glm::dvec3& a, const glm::dvec3& b) const;
    // Returns whether the eye sees the outer side of a face of the box: the upper or lower face normal to `axis`.
    [[nodiscard]] bool sees_face(int axis, bool upper) const;
    [[nodiscard]] int upward_axis() const { return upward_axis_; } // axis that is most vertical in the picture

private:
    const Viewpoint& viewpoint_;
    glm::dmat4 matrix_{};
    glm::dvec3 eye_{}, ahead_{}; // world coordinates
    int upward_axis_ = 0;
};

// Returns at most one edge per axis. Candidates are on the box's silhouette, where they hide nothing and are not
// hidden. The most vertical axis gets its leftmost edge, the others their lowest. Edges shorter than `least` pixels are
// left out. Empty when the eye is inside the box.
[[nodiscard]] std::vector<BoxEdge> axis_edges(const Viewpoint& viewpoint, double least);

} // namespace ciel::annotations
