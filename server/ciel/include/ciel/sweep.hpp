// sweep: cuts a mesh at several values in one pass over the blocks (paper, algorithms 1 and 3). A block of cells is
// loaded into the processor's cache once, and cut at every value in the block's range. Cuts of different blocks share
// no points. sweep_sinks.hpp makes slices of a volume, triangle soups and polygon outlines from the cuts.
#pragma once

#include "ciel/extract.hpp"

#include <functional>
#include <memory>

namespace ciel {

namespace detail {
class Propagation; // src/extraction/propagation.hpp
}

// The cut of one block at one value. A point on an edge that two blocks share is in the cuts of both blocks. Some
// points may belong to no polygon, if cells were skipped or have collapsed.
struct BlockPolygons {
    std::span<const EdgePoint> points;
    std::span<const Vec3f> positions;                  // offsets from the mesh's surface_origin
    std::span<const Index> polygon_end, polygon_point; // end of each polygon in polygon_point; indices in `points`
    std::span<const Index> polygon_cell;               // mesh cell of each polygon, minus cell_begin
    Index cell_begin = 0;

    [[nodiscard]] std::size_t polygon_count() const { return polygon_end.size(); }
    [[nodiscard]] std::span<const Index> polygon(std::size_t i) const {
        const Index begin = i == 0 ? 0 : polygon_end[i - 1];
        return polygon_point.subspan(begin, polygon_end[i] - begin);
    }
};

// Receives the cut of block `block` at values[value]. A cut without polygons causes no call. Several threads may call
// the function at the same time, but only for different blocks. For one block, the calls come in the order of `values`;
// with Algorithm::propagation, in ascending order of the values. `cut` is valid only during the call. `sweep` rethrows
// what the function throws.
using OnCut = std::function<void(std::size_t value, Index block, const BlockPolygons& cut)>;

// Buffers of a sweep. If a sweep is repeated with the same object, it allocates no memory. The buffers never shrink.
// Only one sweep at a time may use an object.
struct SweepScratch {
    std::shared_ptr<detail::Propagation> propagation; // used with Algorithm::propagation only
    std::vector<std::size_t> order;                   // indices of the values, in ascending order of the values
    std::vector<Index> reached; // blocks that may have active cells at the current value of propagation
};

// Cuts the mesh at all values and calls `on_cut` with each cut. The values may be in any order, and may be outside the
// field's range. Returns false when `stop` was requested; some cuts are then missing. Throws Error when the field or
// the mesh belongs to another topology. Uses all threads of parallel_for.
// All algorithms give cuts with the same bits. signatures: cuts each block at all values in the block's range.
// propagation: moves the active edges from the least value to the greatest, starting at the field's minima (algorithm 1
// as printed). At each value, the cells around the active edges are cut. naive: visits every cell for every value.
// The points and polygons, also on ambiguous faces, are the same as those of a Query with the same decider.
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const OnCut& on_cut, SweepScratch& scratch, const StopToken& stop = {}, Extraction extraction = {});

} // namespace ciel
