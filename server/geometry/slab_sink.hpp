// SlabSink: makes the slices of a volume from the cuts of a sweep (ciel/sweep_sinks.hpp). slab_boundary makes the
// boundary of the volume. Any thread may call the functions. The results own their data.
#pragma once

#include "ciel/sweep_sinks.hpp"
#include "color/slab_triangles.hpp"

namespace server::geometry {

// The property of a volume: a scalar on the whole mesh. Does not own the arrays. A cell is filled, that is, belongs to
// the volume, only if its vertices have finite values.
struct SlabProperty {
    const ciel::Topology& topology;
    std::span<const float> value;          // one for each mesh vertex
    std::span<const ciel::Vec3f> gradient; // one for each mesh vertex, per unit of length
    std::span<const std::uint8_t> filled;  // one flag for each cell: 1 if the cell is filled, else 0 (filled_cells)
};

// Sink for `sweep`. Leaves out cells that are not filled. Writes a point once for each block that has the point's edge.
// Therefore the number of points depends on the block size. The polygons do not depend on the block size, but their
// triangle fans may start at other corners.
struct SlabSink {
    SlabProperty property;

    using Piece = color::SlabTriangles;
    using Out = color::SlabTriangles;
    void check(const ciel::TopologyCounts& counts) const;
    void write(const ciel::BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Returns one flag for each cell: 1 if all vertices of the cell have a value in the field, else 0. The flag of a cell
// without faces is unspecified. Reads the blocks that have a vertex without a value.
[[nodiscard]] std::vector<std::uint8_t> filled_cells(const ciel::Field& values);

// Returns the polygons of `faces` as the boundary of a volume. `faces`: the surface around the filled cells
// (threshold_surface, with CollapsedFaces::keep). Its points are mesh vertices. Throws Error when a vertex or a cell of
// `faces` has no entry in an array of the property.
[[nodiscard]] color::SlabTriangles slab_boundary(const ciel::Surface& faces, const SlabProperty& property);

} // namespace server::geometry
