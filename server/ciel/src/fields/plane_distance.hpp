// The signed distance of a vertex from a plane (paper, section 2.1: a slice is an iso-surface of it).
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/face_mesh.hpp"

namespace ciel {

// Borrows the positions.
class PlaneDistance {
public:
    PlaneDistance(const FaceMeshView& points, const Vec3d& origin, const Vec3d& normal)
        : positions_(points.positions), normal_(normal) {
        for (std::size_t i = 0; i < 3; ++i) shift_ += normal[i] * (points.origin[i] - origin[i]);
    }

    [[nodiscard]] float at(std::size_t vertex) const {
        const float* p = &positions_[3 * vertex];
        return static_cast<float>(normal_[0] * p[0] + normal_[1] * p[1] + normal_[2] * p[2] + shift_);
    }
    // Returns ranges that hold the distances of each block's vertices, and may be wider.
    [[nodiscard]] BlockRanges ranges(const BlockBoxes& boxes) const;
    // Returns [min, max] over the vertices that blocks own, whose ids begin at `first_vertex`. `bounds`: what ranges()
    // returned.
    [[nodiscard]] std::array<double, 2> range(const BlockRanges& bounds, std::span<const Index> first_vertex) const;

private:
    std::span<const float> positions_;
    Vec3d normal_;
    double shift_ = 0; // distance from the plane to the mesh's origin; double, because both origins may be large
};

} // namespace ciel
