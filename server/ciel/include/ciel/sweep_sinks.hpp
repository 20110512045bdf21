// Sinks: turn the cuts of a sweep into indexed triangles, triangle soups or outlines. Callers may define other sinks.
// (Paper, algorithm 3, which draws polygon by polygon.)
#pragma once

#include "ciel/parallel.hpp"
#include "ciel/sweep.hpp"

namespace ciel {

// A sink writes each block's cut to a Piece, on any thread, and joins the pieces of one value in the order of the
// blocks. This file has three sinks; SlabSink is in slab.hpp. A sink has these members:
//     using Piece = ...; using Out = ...;
//     void check(const FaceMeshView& mesh) const; // throws Error if an array of the sink has a wrong size
//     void write(const BlockPolygons& cut, Piece& piece) const;
//     void join(std::span<const Piece* const> pieces, Out& out) const;
// SliceSink and SlabSink return a point on an edge that two blocks share once per block. So the number of points
// depends on the block size. The polygons and the triangles of SliceSink do not depend on it. With another block size,
// a fan of SlabSink may start at another corner.

// Sink for blended slices: indexed triangles, a fan per polygon, with a property at the points.
struct SliceSink {
    std::span<const float> property; // one value per mesh vertex
    struct Piece {
        std::vector<Vec3f> positions;
        std::vector<float> property;  // one value per position
        std::vector<Index> triangles; // three indices of positions each
    };
    using Out = Piece;
    void check(const FaceMeshView& mesh) const;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Sink for triangle soups: triangles that share no positions.
struct SoupSink {
    using Piece = std::vector<Vec3f>; // three positions per triangle
    using Out = Piece;
    void check(const FaceMeshView& /*mesh*/) const {}
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Sink for polygon outlines: two positions per polygon side. A side that two polygons share is listed twice.
struct OutlineSink {
    using Piece = std::vector<Vec3f>;
    using Out = Piece;
    void check(const FaceMeshView& /*mesh*/) const {}
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Buffers that sweeps into a sink reuse, so that a repeated sweep allocates no memory. They never shrink.
template <class Sink>
struct SweepParts {
    struct OfBlock {
        std::vector<std::pair<std::size_t, typename Sink::Piece>> piece; // (index of the value, piece)
        std::size_t count = 0;                                           // entries of `piece` used by this sweep
    };
    std::vector<OfBlock> block;
    std::vector<std::vector<const typename Sink::Piece*>> of_value;
    SweepScratch scratch;
};

// Writes the sink's result for values[i] to out[i] and reuses the buffers of `out`. All algorithms give the same bits.
// Returns false, with `out` unspecified, when `stop` was requested. Throws Error as the `sweep` of sweep.hpp does, and
// when an array of the sink has a wrong size. `parts` may be used by one call at a time.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, SweepParts<Sink>& parts, std::vector<typename Sink::Out>& out, const StopToken& stop = {},
           Extraction extraction = {}) {
    sink.check(mesh);
    parts.block.resize(topology.block_count());
    for (auto& made : parts.block) made.count = 0;
    const auto write = [&](std::size_t value, Index block, const BlockPolygons& cut) {
        auto& made = parts.block[block];
        if (made.count == made.piece.size()) made.piece.emplace_back();
        auto& [place, piece] = made.piece[made.count++];
        place = value;
        sink.write(cut, piece);
    };
    // std::cref: a std::function that holds a reference allocates no memory.
    if (!sweep(topology, mesh, field, values, std::cref(write), parts.scratch, stop, extraction)) return false;
    parts.of_value.resize(values.size());
    for (auto& pieces : parts.of_value) pieces.clear();
    for (const auto& made : parts.block)
        for (std::size_t k = 0; k < made.count; ++k)
            parts.of_value[made.piece[k].first].push_back(&made.piece[k].second);
    out.resize(values.size());
    parallel_for(values.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink.join(parts.of_value[i], out[i]);
    });
    return true;
}

// Does the same with temporary buffers, for a single sweep.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop = {},
           Extraction extraction = {}) {
    SweepParts<Sink> parts;
    return sweep(topology, mesh, field, values, sink, parts, out, stop, extraction);
}

} // namespace ciel
