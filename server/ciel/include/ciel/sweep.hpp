// Several values in one pass over the blocks (paper, algorithms 1 and 3): a block's cells are brought into the cache
// once and cut at every value that crosses it. For what wants many values at once and no polygon joined with those of
// other blocks: the blended slices of a volume, a soup of triangles, the polygons' outlines.
#pragma once

#include "ciel/extract.hpp"

#include <memory>

namespace ciel {

class Propagation; // propagation.hpp

// The cut of one block at one value. Points are the block's own: where two blocks meet, both have them. Where cells
// were passed over, or have collapsed, some point may have no polygon.
struct BlockPolygons {
    std::span<const EdgePoint> points;
    std::span<const Vec3f> positions;                  // offsets from the mesh's origin
    std::span<const Index> polygon_end, polygon_point; // into the points
    std::span<const Index> polygon_cell;               // the mesh's cells less cell_begin
    Index cell_begin = 0;

    [[nodiscard]] std::size_t polygon_count() const { return polygon_end.size(); }
    [[nodiscard]] std::span<const Index> polygon(std::size_t i) const {
        const Index begin = i == 0 ? 0 : polygon_end[i - 1];
        return polygon_point.subspan(begin, polygon_end[i] - begin);
    }
};

// A sink makes a Piece of each cut, on any thread, and joins a value's pieces in the order of the blocks. Three kinds
// are below, SlabSink is in slab.hpp; another has
//     using Piece = ...; using Out = ...;
//     void write(const BlockPolygons& cut, Piece& piece) const;
//     void join(std::span<const Piece* const> parts, Out& out) const;
// and a line at the end of sweep.cpp, where the loop is. Points at the border of two blocks are in both, so indexed
// pieces (SliceSink, SlabSink) have other points with other blocks, though the same polygons: SliceSink the same
// triangles, too, while a SlabSink's fan may begin at another corner.

// Indexed triangles, each polygon a fan, with a property at the points: slices to blend.
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

// Triangles with positions of their own.
struct SoupSink {
    using Piece = std::vector<Vec3f>; // three each
    using Out = Piece;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// The polygons' edges, two positions each: the mesh of the surface. An edge of two polygons comes twice.
struct OutlineSink {
    using Piece = std::vector<Vec3f>;
    using Out = Piece;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// What a sweep keeps for the next one, which then asks for no memory: the parts of all values, each as large as it has
// ever been.
template <class Sink>
struct SweepParts {
    struct OfBlock {
        std::vector<std::pair<std::size_t, typename Sink::Piece>> piece; // with the place of its value
        std::size_t count = 0;                                           // how many are of this sweep
    };
    std::vector<OfBlock> block;
    std::vector<std::vector<const typename Sink::Piece*>> of_value;
    std::shared_ptr<Propagation> propagation; // of Algorithm::propagation
    std::vector<std::size_t> order;           // its way through the values
    std::vector<Index> reached;               // and the blocks that it reaches
};

// out[i] is of values[i]; its buffers are used again. Values may be in any order and outside the range. False, leaving
// `out` unspecified, when stop was requested. `out` has the same bits with every algorithm: by signatures, each block
// goes through all values that lie in its range; by propagation, the active edges go from the least value to the
// greatest, from the field's minima (algorithm 1 as it is printed), and the cells around them are cut value by value;
// the naive algorithm looks at each cell for each value. Points, polygons and ambiguous faces are those of a Query with
// the same decider. Uses all threads of the parallel loop, `scratch` by one call at a time; throws Error when the field
// belongs to another topology.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, SweepParts<Sink>& scratch, std::vector<typename Sink::Out>& out,
           const StopToken& stop = {}, Extraction extraction = {});
// The same where there is no next one.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop = {},
           Extraction extraction = {});

} // namespace ciel
