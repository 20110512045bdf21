#include "ciel/sweep.hpp"

#include "ciel/parallel.hpp"
#include "ciel/slab.hpp"
#include "extraction/cut_block.hpp"
#include "extraction/edge_points.hpp"
#include "extraction/join_pieces.hpp"
#include "extraction/propagation.hpp"
#include "fields/field_data.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace ciel {

namespace {

// One block's points and polygons at one value. Scratch, one per thread.
class BlockSlicer {
public:
    // `cells`: those that may be active, if known.
    [[nodiscard]] BlockPolygons cut(const FaceMeshView& mesh, const Field::Data& field, Extraction how, Index b,
                                    double nu, std::optional<std::span<const Index>> cells) {
        const Block& block = field.topology->blocks().block[b];
        const std::span<const float> values = field.of_block(b);
        BlockValues in{
            values, field.gaps[b] != 0, threshold_of(nu), nu, how.decider, {}, how.algorithm == Algorithm::naive};
        if (how.algorithm == Algorithm::signatures) in.ranges = field.ranges.of(block, b, values);
        CutScratch& scratch = scratch_of_this_thread();
        if (cells)
            cut_cells_alone(block, in, *cells, scratch, cut_);
        else
            cut_block_alone(block, in, scratch, cut_);
        points_.resize(scratch.met_count);
        positions_.resize(scratch.met_count);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            points_[i] = edge_point(block, values, scratch.ends[i], nu);
            positions_[i] = position_of(points_[i], mesh.positions);
        }
        return {points_, positions_, cut_.polygon_end, cut_.polygon_edge, cut_.polygon_cell, block.cell_begin};
    }

private:
    ActiveBlock cut_;
    std::vector<EdgePoint> points_;
    std::vector<Vec3f> positions_;
};

BlockSlicer& block_slicer_of_this_thread() {
    static thread_local BlockSlicer block_slicer;
    return block_slicer;
}

std::size_t triangle_count(const BlockPolygons& cut) { return cut.polygon_point.size() - 2 * cut.polygon_count(); }

// Calls f(a, b, c) for the triangles of a fan from each polygon's first point.
template <class F>
void for_triangles(const BlockPolygons& cut, F&& f) {
    const Index* point = cut.polygon_point.data();
    Index begin = 0;
    for (const Index end : cut.polygon_end) {
        for (Index k = begin + 2; k < end; ++k) f(point[begin], point[k - 1], point[k]);
        begin = end;
    }
}

} // namespace

void SliceSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.positions.assign(cut.positions.begin(), cut.positions.end());
    piece.property.resize(cut.points.size());
    std::ranges::transform(cut.points, piece.property.begin(), [this](const EdgePoint& point) {
        return lerp(property[point.a], property[point.b], point.t);
    });
    piece.triangles.resize(3 * triangle_count(cut));
    Index* to = piece.triangles.data();
    for_triangles(cut, [&](Index a, Index b, Index c) {
        to[0] = a;
        to[1] = b;
        to[2] = c;
        to += 3;
    });
}

void SliceSink::join(std::span<const Piece* const> pieces, Out& out) const {
    join_arrays(pieces, &Piece::positions, out);
    join_arrays(pieces, &Piece::property, out);
    join_triangles(pieces, &Piece::positions, out);
}

void SoupSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.resize(3 * triangle_count(cut));
    Vec3f* to = piece.data();
    const Vec3f* position = cut.positions.data();
    for_triangles(cut, [&](Index a, Index b, Index c) {
        to[0] = position[a];
        to[1] = position[b];
        to[2] = position[c];
        to += 3;
    });
}

void SoupSink::join(std::span<const Piece* const> pieces, Out& out) const { join_arrays(pieces, std::identity(), out); }

void OutlineSink::write(const BlockPolygons& cut, Piece& piece) const {
    piece.clear();
    piece.reserve(2 * cut.polygon_point.size());
    for (std::size_t i = 0; i < cut.polygon_count(); ++i) {
        Index before = cut.polygon(i).back();
        for (const Index p : cut.polygon(i)) {
            piece.push_back(cut.positions[before]);
            piece.push_back(cut.positions[p]);
            before = p;
        }
    }
}

void OutlineSink::join(std::span<const Piece* const> pieces, Out& out) const {
    join_arrays(pieces, std::identity(), out);
}

namespace {

void require(std::size_t found, std::size_t wanted, const char* what) {
    if (found != wanted)
        fail("a sweep needs " + std::to_string(wanted) + " " + what + ", not " + std::to_string(found));
}

void check(const SliceSink& sink, const FaceMeshView& mesh) {
    require(sink.property.size(), mesh.vertex_count(), "values, one per vertex");
}

void check(const SlabSink& sink, const FaceMeshView& mesh) {
    require(sink.property.value.size(), mesh.vertex_count(), "values, one per vertex");
    require(sink.property.gradient.size(), mesh.vertex_count(), "gradients, one per vertex");
    require(sink.property.limits.size(), mesh.cell_count(), "limits, one per cell");
}

template <class Sink>
void check(const Sink&, const FaceMeshView&) {} // has no arrays to check

// One sweep, with the scratch that is kept.
template <class Sink>
struct Pass {
    const Topology& topology;
    const FaceMeshView& mesh;
    const Field& field;
    std::span<const double> values;
    const Sink& sink;
    Extraction how;
    SweepParts<Sink>& scratch;
    const StopToken& stop;

    void write(Index b, std::size_t value, std::optional<std::span<const Index>> cells) {
        const BlockPolygons cut = block_slicer_of_this_thread().cut(mesh, field.data(), how, b, values[value], cells);
        if (cut.polygon_count() == 0) return;
        auto& made = scratch.block[b];
        if (made.count == made.piece.size()) made.piece.emplace_back();
        auto& [place, piece] = made.piece[made.count++];
        place = value;
        sink.write(cut, piece);
    }

    // Block by block.
    void cut_blocks() {
        const Field::Data& blocks = field.data();
        parallel_for(scratch.block.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end && !stop.stop_requested(); ++b)
                for (std::size_t i = 0; i < values.size(); ++i) {
                    const float threshold = threshold_of(values[i]);
                    if (how.algorithm == Algorithm::naive || (blocks.low[b] < threshold && blocks.high[b] >= threshold))
                        write(static_cast<Index>(b), i, {});
                }
        });
    }

    // Value by value, upwards. Returns false when stopped.
    bool propagate() {
        if (!scratch.propagation) scratch.propagation = std::make_shared<Propagation>();
        Propagation& propagation = *scratch.propagation;
        propagation.begin(topology, field);
        scratch.order.resize(values.size());
        std::iota(scratch.order.begin(), scratch.order.end(), std::size_t{0});
        std::ranges::sort(scratch.order, {}, [&](std::size_t i) { return std::pair(threshold_of(values[i]), i); });
        for (const std::size_t i : scratch.order) {
            if (!propagation.reach(values[i], stop)) return false;
            propagation.list_blocks(scratch.reached);
            parallel_for(scratch.reached.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end && !stop.stop_requested(); ++k) {
                    const Index b = scratch.reached[k];
                    propagation.settle(b);
                    if (!propagation.cells(b).empty()) write(b, i, propagation.cells(b));
                }
            });
        }
        return true;
    }
};

} // namespace

template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, SweepParts<Sink>& scratch, std::vector<typename Sink::Out>& out, const StopToken& stop,
           Extraction extraction) {
    if (field.data().topology != &topology) fail("the field belongs to another topology");
    if (mesh.vertex_count() != topology.counts().vertices || mesh.cell_count() != topology.counts().cells)
        fail("the mesh is not the one that the topology was built from");
    check(sink, mesh);
    scratch.block.resize(topology.block_count());
    for (auto& made : scratch.block) made.count = 0;
    Pass<Sink> pass{topology, mesh, field, values, sink, extraction, scratch, stop};
    if (extraction.algorithm == Algorithm::propagation) {
        if (!pass.propagate()) return false;
    } else {
        pass.cut_blocks();
    }
    if (stop.stop_requested()) return false;
    scratch.of_value.resize(values.size());
    for (auto& pieces : scratch.of_value) pieces.clear();
    for (const auto& made : scratch.block)
        for (std::size_t k = 0; k < made.count; ++k)
            scratch.of_value[made.piece[k].first].push_back(&made.piece[k].second);
    out.resize(values.size());
    parallel_for(values.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink.join(scratch.of_value[i], out[i]);
    });
    return true;
}

template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop, Extraction extraction) {
    SweepParts<Sink> scratch;
    return sweep(topology, mesh, field, values, sink, scratch, out, stop, extraction);
}

#define CIEL_SWEEP(Sink)                                                                                               \
    template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const Sink&,      \
                        SweepParts<Sink>&, std::vector<Sink::Out>&, const StopToken&, Extraction);                     \
    template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const Sink&,      \
                        std::vector<Sink::Out>&, const StopToken&, Extraction);

CIEL_SWEEP(SliceSink)
CIEL_SWEEP(SoupSink)
CIEL_SWEEP(OutlineSink)
CIEL_SWEEP(SlabSink)
#undef CIEL_SWEEP

} // namespace ciel
