// Slices for volume rendering (paper, sections 2 and 3). The mesh is cut by the middle planes of parallel slabs. Each
// point has the property and its gradient, so the property can be evaluated through the slab along any ray.
#pragma once

#include "ciel/sweep.hpp"

namespace ciel {

struct SlabVertex {
    Vec3f position; // offset from the mesh's origin
    float value;    // of the property
    Vec3f gradient; // of the property, per length
    // [min, max] of the property in the cell of the polygon whose triangles start at this vertex.
    std::array<float, 2> limits;
};

// Triangles; each polygon is a fan. Its first vertex is first in no other fan and has the polygon's `limits`.
struct SlabMesh {
    std::vector<SlabVertex> vertices;
    std::vector<Index> triangles; // three vertices each

    [[nodiscard]] std::size_t memory_bytes() const {
        return vertices.capacity() * sizeof(SlabVertex) + triangles.capacity() * sizeof(Index);
    }
};

// Limits of a cell that is not filled: low > high.
inline constexpr std::array<float, 2> not_filled{std::numeric_limits<float>::infinity(),
                                                 -std::numeric_limits<float>::infinity()};

// [min, max] of the values at each cell's vertices; not_filled where one of them is NaN or infinite.
[[nodiscard]] std::vector<std::array<float, 2>> cell_limits(const FaceMeshView& mesh, std::span<const float> values);

// The property at the mesh's V vertices and C cells. Borrowed, and must have these sizes.
struct SlabProperty {
    std::span<const float> value;                 // V
    std::span<const Vec3f> gradient;              // V, per length
    std::span<const std::array<float, 2>> limits; // C
};

// Sink for `sweep`. Writes filled cells only.
struct SlabSink {
    SlabProperty property;

    using Piece = SlabMesh;
    using Out = SlabMesh;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Boundary of the filled cells as a SlabMesh, wound outwards.
[[nodiscard]] SlabMesh slab_boundary(const FaceMeshView& mesh, const SlabProperty& property);

} // namespace ciel
