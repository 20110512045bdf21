// The signed distance of a vertex from a plane (paper, section 2.1: a slice is an iso-surface of this distance).
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/face_mesh.hpp"

namespace ciel::detail {

// Does not own the positions, which must outlive the object. A distance has the type of the positions, float or double.
class PlaneDistance {
public:
    PlaneDistance(const FaceMeshView& points, const Vec3d& origin, const Vec3d& normal)
        : positions_(points.positions), loader_(points.loader), normal_(normal) {
        for (std::size_t i = 0; i < 3; ++i) shift_ += normal[i] * (points.origin[i] - origin[i]);
    }

    [[nodiscard]] bool has_doubles() const { return positions_.has_doubles(); }
    [[nodiscard]] std::size_t vertex_count() const { return positions_.size() / 3; }
    // Returns null if all positions are in memory. Otherwise, load the positions before at() or of() reads them.
    [[nodiscard]] const VertexLoader* loader() const { return loader_; }
    // Returns the distance of a vertex, rounded to a float unless has_doubles().
    [[nodiscard]] double at(std::size_t vertex) const {
        return has_doubles() ? of<double>().at(vertex) : double{of<float>().at(vertex)};
    }

    template <class Number>
    struct Of {
        const Number* positions;
        Vec3d normal;
        double shift;

        [[nodiscard]] Number at(std::size_t vertex) const {
            const Number* p = &positions[3 * vertex];
            return static_cast<Number>(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + shift);
        }
    };
    // REQUIRES: Number is double if has_doubles(), else float.
    template <class Number>
    [[nodiscard]] Of<Number> of() const {
        return {static_cast<const Number*>(positions_.data()), normal_, shift_};
    }

    // Returns the range of each block, which may be wider than the range of its distances. `boxes`: the result of
    // block_boxes for the positions.
    [[nodiscard]] BlockRanges ranges(const BlockBoxes& boxes) const;
    // Returns [min, max] over the vertices that blocks own. `bounds`: the result of ranges(). `first_vertex`: the first
    // vertex that each block owns, then the end of the last block's vertices.
    [[nodiscard]] std::array<double, 2> range(const BlockRanges& bounds, std::span<const Index> first_vertex) const;

private:
    ValuesView positions_;
    const VertexLoader* loader_;
    Vec3d normal_;
    double shift_ = 0; // distance from the plane to the mesh's origin; double, because both origins may be large
};

// Returns the distance of each vertex. Number: float, or double for a mesh with double positions.
template <class Number>
[[nodiscard]] std::vector<Number> plane_distances(const FaceMeshView& mesh, const Vec3d& origin, const Vec3d& normal);

} // namespace ciel::detail
