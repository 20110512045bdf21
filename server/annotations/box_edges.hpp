// The edges of a box in a picture, as an axis of a diagram wants them.
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
    double from = 0, to = 1;  // the part of it that is in the picture, as shares of the way from low to high
    Place outward;            // of length 1, across the edge, away from the box
};

// Places in the picture of a viewpoint.
class Projection {
public:
    explicit Projection(const Viewpoint& viewpoint);
    [[nodiscard]] glm::dvec4 clip(const glm::dvec3& world) const;
    [[nodiscard]] Place pixel(const glm::dvec3& world) const; // of a point in front of the eye
    // Which part of a line from a to b is between the nearest plane and the farthest and inside the picture.
    [[nodiscard]] std::optional<std::pair<double, double>> part_seen(const glm::dvec3& a, const glm::dvec3& b) const;
    // Whether the eye is on the outer side of the box's lower or upper face across an axis.
    [[nodiscard]] bool sees_face(int axis, bool upper) const;
    [[nodiscard]] int upward_axis() const { return upward_axis_; } // the one that runs up the picture more than others

private:
    const Viewpoint& viewpoint_;
    glm::dmat4 matrix_{};
    glm::dvec3 eye_{}, ahead_{}; // world coordinates
    int upward_axis_ = 0;
};

// At most one edge along each axis: of those on the box's silhouette, where they hide nothing and nothing hides them,
// the leftmost along the axis that runs up the picture, and the lowest along the other two. Edges that are seen from
// their end, or not at all, are left out; so is everything when the eye is inside the box. Edges shorter than `least`
// pixels count as seen from their end.
[[nodiscard]] std::vector<BoxEdge> axis_edges(const Viewpoint& viewpoint, double least);

} // namespace ciel::annotations
