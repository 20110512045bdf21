// sweep: cuts a mesh at several values in one pass over the blocks (paper, algorithms 1 and 3). A block's cells are
// loaded into the cache once and cut at every value in the block's range. Cuts of different blocks share no points.
// sweep_sinks.hpp makes slices of a volume, triangle soups and polygon outlines from the cuts.
#pragma once

#include "ciel/extract.hpp"

#include <functional>
#include <memory>

namespace ciel {

class Propagation; // propagation.hpp

// The cut of one block at one value. A point on an edge that two blocks share is in the cuts of both. A point may
// belong to no polygon, if cells were skipped or have collapsed.
struct BlockPolygons {
    std::span<const EdgePoint> points;
    std::span<const Vec3f> positions;                  // of the points, as offsets from the mesh's surface_origin
    std::span<const Index> polygon_end, polygon_point; // end of each polygon in polygon_point; indices of points
    std::span<const Index> polygon_cell;               // id of the cut mesh cell minus cell_begin
    Index cell_begin = 0;

    [[nodiscard]] std::size_t polygon_count() const { return polygon_end.size(); }
    [[nodiscard]] std::span<const Index> polygon(std::size_t i) const {
        const Index begin = i == 0 ? 0 : polygon_end[i - 1];
        return polygon_point.subspan(begin, polygon_end[i] - begin);
    }
};

// Receives the cut of block `block` at values[value], if the cut has polygons. Several threads may call it at the same
// time, but for different blocks. The cuts of one block come in the order of `values`; with Algorithm::propagation in
// ascending order of value. `cut` is valid during the call. `sweep` rethrows its exceptions.
using OnCut = std::function<void(std::size_t value, Index block, const BlockPolygons& cut)>;

// Buffers that sweeps reuse, so that a repeated sweep allocates no memory. They never shrink. For one sweep at a time.
struct SweepScratch {
    std::shared_ptr<Propagation> propagation; // used with Algorithm::propagation only
    std::vector<std::size_t> order;           // indices of the values, by ascending value
    std::vector<Index> reached;               // blocks with active edges at the current value of propagation
};

// Cuts the mesh at all values. Values may be in any order and outside the field's range. Returns false when `stop` was
// requested; some cuts are then missing. Throws Error when the field or the mesh belongs to another topology. Uses all
// threads of the parallel loop.
// All algorithms give cuts with the same bits. signatures: cuts each block at all values in its range. propagation:
// moves the active edges from the least value to the greatest, starting at the field's minima (algorithm 1 as printed),
// and cuts the cells around them at each value. naive: visits every cell for every value.
// Points, polygons and ambiguous faces are those of a Query with the same decider.
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const OnCut& on_cut, SweepScratch& scratch, const StopToken& stop = {}, Extraction extraction = {});

} // namespace ciel
