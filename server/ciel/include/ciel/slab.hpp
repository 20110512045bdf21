// Slices for volume rendering (paper, sections 2 and 3). The volume is divided into parallel slabs, and the mesh is cut
// by the middle plane of each slab. The property is the scalar that is drawn. Each vertex of a slice has the value and
// the gradient of the property. Therefore a renderer can evaluate the property along any ray through the slab.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/sweep_sinks.hpp"

namespace ciel {

struct SlabVertex {
    Vec3f position; // offset from the mesh's surface_origin
    float value;    // value of the property
    Vec3f gradient; // gradient of the property, per unit of length
    // [min, max] of the property in one cell: the cell of the polygon whose triangles all start at this vertex. Unused
    // in vertices at which no polygon's triangles start.
    std::array<float, 2> limits;
};

// Polygons as triangle fans. All triangles of a polygon start at the same vertex, which has the limits of the polygon's
// cell. The triangles of at most one polygon start at a vertex.
struct SlabMesh {
    std::vector<SlabVertex> vertices;
    std::vector<Index> triangles; // three indices in `vertices` for each triangle

    [[nodiscard]] std::size_t memory_bytes() const {
        return vertices.capacity() * sizeof(SlabVertex) + triangles.capacity() * sizeof(Index);
    }
};

// Limits of a cell that is not drawn as a part of the volume: low > high.
inline constexpr std::array<float, 2> not_filled{std::numeric_limits<float>::infinity(),
                                                 -std::numeric_limits<float>::infinity()};

// Returns [min, max] of the values at the vertices of each cell, or not_filled if a value is NaN or infinite. `values`:
// one for each vertex. Throws Error when `values` has another size. Uses all threads of parallel_for.
[[nodiscard]] std::vector<std::array<float, 2>> cell_limits(const Topology& topology, std::span<const float> values);

// The property on the whole mesh. Does not own the arrays.
struct SlabProperty {
    std::span<const float> value;                 // one for each mesh vertex
    std::span<const Vec3f> gradient;              // one for each mesh vertex, per unit of length
    std::span<const std::array<float, 2>> limits; // one for each cell (cell_limits)
};

// Sink for `sweep` (sweep_sinks.hpp) that makes the slices of a volume. Leaves out cells whose limits are not_filled.
struct SlabSink {
    SlabProperty property;

    using Piece = SlabMesh;
    using Out = SlabMesh;
    void check(const FaceMeshView& mesh) const;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Returns the boundary of the filled cells, wound outwards. A cell is filled unless its limits are not_filled.
// `boundary`: the boundary faces of the mesh. `boxes`: the result of block_boxes for the positions of the mesh. Reads
// the same blocks as threshold_surface; reads no block if all cells are filled. Throws Error when the arguments belong
// to another mesh than the topology. Uses all threads of parallel_for.
[[nodiscard]] SlabMesh slab_boundary(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                                     const SlabProperty& property);

} // namespace ciel
