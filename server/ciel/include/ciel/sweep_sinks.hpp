// Sinks: convert the cuts of a sweep to indexed triangles, triangle soups or outlines (paper, algorithm 3, which draws
// polygon by polygon). Callers may define other sinks.
#pragma once

#include "ciel/parallel.hpp"
#include "ciel/sweep.hpp"

namespace ciel {

// A sink converts the cut of each block to a Piece, on any thread. Then it joins the pieces of each value, in the order
// of the blocks. This file has three sinks. sink_pieces.hpp has functions for further ones. A sink has these members:
//     using Piece = ...; using Out = ...;
//     void check(const TopologyCounts& counts) const; // throws Error if an array of the sink has a wrong size
//     void write(const BlockPolygons& cut, Piece& piece) const;
//     void join(std::span<const Piece* const> pieces, Out& out) const;
// SliceSink writes a point once for each block that has the point's edge. Therefore the number of points depends on the
// block size. The number and shape of the triangles do not.

// Sink for blended slices: a fan of indexed triangles for each polygon, and a property at the points.
struct SliceSink {
    std::span<const float> property; // one value for each mesh vertex
    struct Piece {
        std::vector<Vec3f> positions;
        std::vector<float> property;  // one value for each position
        std::vector<Index> triangles; // three indices in `positions` for each triangle
    };
    using Out = Piece;
    void check(const TopologyCounts& counts) const;
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Sink for triangle soups: triangles that share no positions.
struct SoupSink {
    using Piece = std::vector<Vec3f>; // three positions for each triangle
    using Out = Piece;
    void check(const TopologyCounts& /*counts*/) const {}
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Sink for polygon outlines: two positions for each polygon side. A side of two polygons is listed twice.
struct OutlineSink {
    using Piece = std::vector<Vec3f>;
    using Out = Piece;
    void check(const TopologyCounts& /*counts*/) const {}
    void write(const BlockPolygons& cut, Piece& piece) const;
    void join(std::span<const Piece* const> pieces, Out& out) const;
};

// Buffers of a sweep into a sink. If a sweep is repeated with the same object, it allocates no memory. The buffers
// never shrink. Only one sweep at a time may use an object.
template <class Sink>
struct SweepBuffers {
    struct OfBlock {
        std::vector<std::pair<std::size_t, typename Sink::Piece>> piece; // (index of the value, piece)
        std::size_t count = 0; // number of entries of `piece` that the current sweep uses
    };
    std::vector<OfBlock> block;
    std::vector<std::vector<const typename Sink::Piece*>> of_value;
    SweepScratch scratch;
};

// Sets out[i] to the sink's result for values[i], and reuses the buffers of `out`. All algorithms give the same bits.
// Returns false when `stop` was requested; `out` is then unspecified. Throws Error when the `sweep` of sweep.hpp does,
// and when an array of the sink has a wrong size.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, SweepBuffers<Sink>& buffers, std::vector<typename Sink::Out>& out,
           const StopToken& stop = {}, Extraction extraction = {}) {
    sink.check(topology.counts());
    buffers.block.resize(topology.block_count());
    for (auto& made : buffers.block) made.count = 0;
    const auto write = [&](std::size_t value, Index block, const BlockPolygons& cut) {
        auto& made = buffers.block[block];
        if (made.count == made.piece.size()) made.piece.emplace_back();
        auto& [place, piece] = made.piece[made.count++];
        place = value;
        sink.write(cut, piece);
    };
    // std::cref: a std::function that holds a reference allocates no memory.
    if (!sweep(topology, mesh, field, values, std::cref(write), buffers.scratch, stop, extraction)) return false;
    buffers.of_value.resize(values.size());
    for (auto& pieces : buffers.of_value) pieces.clear();
    for (const auto& made : buffers.block)
        for (std::size_t k = 0; k < made.count; ++k)
            buffers.of_value[made.piece[k].first].push_back(&made.piece[k].second);
    out.resize(values.size());
    parallel_for(values.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink.join(buffers.of_value[i], out[i]);
    });
    return true;
}

// Like the function above, with temporary buffers for a single sweep.
template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop = {},
           Extraction extraction = {}) {
    SweepBuffers<Sink> buffers;
    return sweep(topology, mesh, field, values, sink, buffers, out, stop, extraction);
}

} // namespace ciel
