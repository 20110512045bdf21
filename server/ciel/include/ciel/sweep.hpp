// Several values in one pass over the blocks (paper, algorithms 1 and 3). The cells of a block are loaded into the
// cache once and cut at every value that crosses it. For output with many values and no points shared between blocks:
// blended slices of a volume, triangle soups, polygon outlines.
#pragma once

#include "ciel/extract.hpp"

#include <memory>

namespace ciel {

class Propagation; // propagation.hpp

// The cut of one block at one value. Points are per block: where two blocks meet, both have the point. Where cells were
// skipped or have collapsed, a point may have no polygon.
struct BlockPolygons {
    std::span<const EdgePoint> points;
    std::span<const Vec3f> positions;                  // offsets from the mesh's origin
    std::span<const Index> polygon_end, polygon_point; // into the points
    std::span<const Index> polygon_cell;               // mesh cell - cell_begin
    Index cell_begin = 0;

    [[nodiscard]] std::size_t polygon_count() const { return polygon_end.size(); }
    [[nodiscard]] std::span<const Index> polygon(std::size_t i) const {
        const Index begin = i == 0 ? 0 : polygon_end[i - 1];
        return polygon_point.subspan(begin, polygon_end[i] - begin);
    }
};

// A sink makes a Piece of each cut, on any thread, and joins the pieces of a value in the order of the blocks. Three
// sinks are below, SlabSink is in slab.hpp. Another sink has
//     using Piece = ...; using Out = ...;
//     void write(const BlockPolygons& cut, Piece& piece) const;
//     void join(std::span<const Piece* const> parts, Out& out) const;
// and a line at the end of sweep.cpp, which instantiates `sweep`.
// Points at the border of two blocks are in both. So the points of indexed pieces (SliceSink, SlabSink) depend on the
// blocks; their polygons do not. The triangles of SliceSink do not either; a fan of SlabSink may start at another
// corner.

// Indexed triangles (each polygon is a fan) with a property at the points. For blended slices.
struct SliceSink {
    std::span<const float> property; // by mesh vertex
    struct Piece {
        std::vector<Vec3f> positions;
        std::vector<float> property;
        std::vector<Index> triangles; // three points each
    };
    using Out = Piece;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Triangles that share no positions.
struct SoupSink {
    using Piece = std::vector<Vec3f>; // three per triangle
    using Out = Piece;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// The polygons' edges, two positions each: the mesh of the surface. An edge of two polygons is listed twice.
struct OutlineSink {
    using Piece = std::vector<Vec3f>;
    using Out = Piece;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Buffers that a sweep keeps so that the next one allocates nothing. They never shrink.
template <class Sink>
struct SweepParts {
    struct OfBlock {
        std::vector<std::pair<std::size_t, typename Sink::Piece>> piece; // each with the index of its value
        std::size_t count = 0;                                           // pieces of this sweep
    };
    std::vector<OfBlock> block;
    std::vector<std::vector<const typename Sink::Piece*>> of_value;
    std::shared_ptr<Propagation> propagation; // for Algorithm::propagation
    std::vector<std::size_t> order;           // indices of the values, by ascending value
    std::vector<Index> reached;               // blocks that propagation has reached
};

// Writes the result of values[i] to out[i] and reuses its buffers. Values may be in any order and outside the range.
// Returns false, with `out` unspecified, when stop was requested. Throws Error when the field or the mesh belongs to
// another topology, or an array of the sink has a wrong size. Uses all threads of the parallel loop; one call at a time
// per `scratch`.
// `out` has the same bits with every algorithm. signatures: each block handles all values in its range. propagation:
// the active edges move from the least value to the greatest, starting at the field's minima (algorithm 1 as printed),
// and the cells around them are cut value by value. naive: each cell is visited for each value.
// Points, polygons and ambiguous faces are those of a Query with the same decider.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, SweepParts<Sink>& scratch, std::vector<typename Sink::Out>& out,
           const StopToken& stop = {}, Extraction extraction = {});
// The same without scratch for a next sweep.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop = {},
           Extraction extraction = {});

} // namespace ciel
