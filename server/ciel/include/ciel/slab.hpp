// Slices for volume rendering (paper, sections 2 and 3). The mesh is cut by the middle planes of parallel slabs. The
// property is the scalar that is drawn. Each point of a slice has its value and its gradient, so a renderer can
// evaluate the property along any ray through the slab.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/sweep_sinks.hpp"

namespace ciel {

struct SlabVertex {
    Vec3f position; // offset from the mesh's surface_origin
    float value;    // of the property
    Vec3f gradient; // of the property, per length
    // [min, max] of the property in the cell of one polygon: the polygon whose triangles all start at this vertex.
    std::array<float, 2> limits;
};

// Polygons as fans of triangles. A vertex starts the triangles of at most one polygon, whose `limits` it holds.
struct SlabMesh {
    std::vector<SlabVertex> vertices;
    std::vector<Index> triangles; // three vertices each

    [[nodiscard]] std::size_t memory_bytes() const {
        return vertices.capacity() * sizeof(SlabVertex) + triangles.capacity() * sizeof(Index);
    }
};

// Limits of a cell that the volume leaves empty: low > high.
inline constexpr std::array<float, 2> not_filled{std::numeric_limits<float>::infinity(),
                                                 -std::numeric_limits<float>::infinity()};

// Returns [min, max] of the values at the vertices of each cell; not_filled if one of them is NaN or infinite.
// `values`: one per vertex; throws Error on another number. Uses all threads of the parallel loop.
[[nodiscard]] std::vector<std::array<float, 2>> cell_limits(const Topology& topology, std::span<const float> values);

// The property on the whole mesh. Does not own its arrays.
struct SlabProperty {
    std::span<const float> value;                 // one per mesh vertex
    std::span<const Vec3f> gradient;              // one per mesh vertex, per length
    std::span<const std::array<float, 2>> limits; // one per cell (cell_limits)
};

// Sink for `sweep` (sweep.hpp) that makes the slices of a volume. Cells whose limits are not_filled are left out.
struct SlabSink {
    SlabProperty property;

    using Piece = SlabMesh;
    using Out = SlabMesh;
    void check(const FaceMeshView& mesh) const;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Returns the boundary of the filled cells, wound outwards. A cell is filled unless its limits are not_filled.
// boundary: the boundary faces of the mesh. boxes: what block_boxes returned for its positions. Reads blocks as
// threshold_surface does, and none if all cells are filled. Throws Error when the arguments are of another mesh than
// the topology.
[[nodiscard]] SlabMesh slab_boundary(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                                     const SlabProperty& property);

} // namespace ciel
