// The edges of a box in a picture, chosen to carry axes.
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
    Place outward;            // of length 1, across the edge, away from the box
};

// Projects world coordinates to the picture of a viewpoint, which it borrows.
class Projection {
public:
    explicit Projection(const Viewpoint& viewpoint);
    [[nodiscard]] glm::dvec4 clip(const glm::dvec3& world) const;
    [[nodiscard]] Place pixel(const glm::dvec3& world) const; // of a point in front of the eye
    // The part of the line from a to b inside the view volume, as fractions from a to b; none if it is outside.
    [[nodiscard]] std::optional<std::pair<double, double>> part_seen(const glm::dvec3& a, const glm::dvec3& b) const;
    // Whether the eye is on the outer side of the box's lower or upper face across an axis.
    [[nodiscard]] bool sees_face(int axis, bool upper) const;
    [[nodiscard]] int upward_axis() const { return upward_axis_; } // the most vertical one in the picture

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
