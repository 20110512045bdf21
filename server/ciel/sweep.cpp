#include "ciel/sweep.hpp"

#include "ciel/cut_block.hpp"
#include "ciel/edge_points.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"
#include "ciel/slab.hpp"

#include <algorithm>

namespace ciel {

namespace {

// One block's points and polygons at one value. Scratch, one per thread.
class BlockSweep {
public:
    BlockSweep(const FaceMeshView& mesh, const Field::Blocks& field) : mesh_(mesh), field_(field) {}

    [[nodiscard]] BlockCut cut(Index b, double nu) {
        const Block& block = field_.topology->blocks().block[b];
        const std::span<const float> values = field_.of_block(b);
        const BlockValues in{values, field_.gaps[b] != 0,   threshold_of(nu),
                             nu,     Decider::isolate_high, field_.ranges.of(block, b, values)};
        CutScratch& scratch = scratch_of_this_thread();
        (void)classify(values, in.threshold, scratch, cut_);
        cut_block(block, in, scratch, cut_);
        place_points(block, values, nu);
        return {points_, positions_, cut_.polygon_end, cut_.polygon_edge, cut_.polygon_cell, block.cell_begin};
    }

private:
    // All active edges, and then the polygons' edges are told as places among them.
    void place_points(const Block& block, std::span<const float> values, double nu) {
        points_.resize(cut_.ends.size());
        positions_.resize(cut_.ends.size());
        for (std::size_t i = 0; i < cut_.ends.size(); ++i) {
            points_[i] = edge_point(block, values, cut_.ends[i], nu);
            positions_[i] = position_of(points_[i], mesh_.positions);
        }
        place_.resize(64 * cut_.active.size());
        Index i = 0;
        for (std::size_t w = 0; w < cut_.active.size(); ++w)
            for (std::uint64_t bits = cut_.active[w]; bits != 0; bits &= bits - 1)
                place_[64 * w + static_cast<std::size_t>(std::countr_zero(bits))] = i++;
        for (Index& edge : cut_.polygon_edge) edge = place_[edge];
    }

    const FaceMeshView& mesh_;
    const Field::Blocks& field_;
    CutBlock cut_;
    std::vector<EdgePoint> points_;
    std::vector<Vec3f> positions_;
    std::vector<Index> place_;
};

std::size_t triangle_count(const BlockCut& cut) { return cut.polygon_point.size() - 2 * cut.polygon_count(); }

// Calls f(a, b, c) for the triangles of a fan from each polygon's first point.
template <class F>
void for_triangles(const BlockCut& cut, F&& f) {
    for (std::size_t i = 0; i < cut.polygon_count(); ++i) {
        const std::span<const Index> loop = cut.polygon(i);
        for (std::size_t k = 2; k < loop.size(); ++k) f(loop[0], loop[k - 1], loop[k]);
    }
}

template <class T>
void append_all(std::span<const std::vector<T>* const> parts, std::vector<T>& out) {
    std::size_t size = 0;
    for (const auto* part : parts) size += part->size();
    out.clear();
    out.reserve(size);
    for (const auto* part : parts) out.insert(out.end(), part->begin(), part->end());
}

} // namespace

void SliceSink::write(const BlockCut& cut, Part& part) const {
    part.positions.assign(cut.positions.begin(), cut.positions.end());
    part.property.clear();
    for (const EdgePoint& point : cut.points)
        part.property.push_back(lerp(property[point.a], property[point.b], point.t));
    part.triangles.clear();
    part.triangles.reserve(3 * triangle_count(cut));
    for_triangles(cut, [&](Index a, Index b, Index c) { part.triangles.insert(part.triangles.end(), {a, b, c}); });
}

void SliceSink::join(std::span<const Part* const> parts, Out& out) const {
    std::size_t points = 0, corners = 0;
    for (const Part* part : parts) {
        points += part->positions.size();
        corners += part->triangles.size();
    }
    out.positions.clear();
    out.positions.reserve(points);
    out.property.clear();
    out.property.reserve(points);
    out.triangles.resize(corners);
    Index* to = out.triangles.data();
    for (const Part* part : parts) {
        const auto first = static_cast<Index>(out.positions.size());
        to = std::ranges::transform(part->triangles, to, [first](Index p) { return first + p; }).out;
        out.positions.insert(out.positions.end(), part->positions.begin(), part->positions.end());
        out.property.insert(out.property.end(), part->property.begin(), part->property.end());
    }
}

void SoupSink::write(const BlockCut& cut, Part& part) const {
    part.clear();
    part.reserve(3 * triangle_count(cut));
    for_triangles(cut, [&](Index a, Index b, Index c) {
        for (const Index p : {a, b, c}) part.push_back(cut.positions[p]);
    });
}

void SoupSink::join(std::span<const Part* const> parts, Out& out) const { append_all(parts, out); }

void OutlineSink::write(const BlockCut& cut, Part& part) const {
    part.clear();
    part.reserve(2 * cut.polygon_point.size());
    for (std::size_t i = 0; i < cut.polygon_count(); ++i) {
        Index before = cut.polygon(i).back();
        for (const Index p : cut.polygon(i)) {
            part.push_back(cut.positions[before]);
            part.push_back(cut.positions[p]);
            before = p;
        }
    }
}

void OutlineSink::join(std::span<const Part* const> parts, Out& out) const { append_all(parts, out); }

template <class Sink>
bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const Sink& sink, std::vector<typename Sink::Out>& out, const StopToken& stop) {
    using Part = typename Sink::Part;
    const Field::Blocks& blocks = field.blocks();
    if (blocks.topology != &topology) fail("the field belongs to another topology");
    struct Made {
        std::size_t value;
        Part part;
    };
    std::vector<std::vector<Made>> made(topology.block_count());
    parallel_for(made.size(), 1, [&](std::size_t begin, std::size_t end) {
        BlockSweep block_sweep(mesh, blocks);
        for (std::size_t b = begin; b < end && !stop.stop_requested(); ++b)
            for (std::size_t i = 0; i < values.size(); ++i) {
                const float threshold = threshold_of(values[i]);
                if (!(blocks.low[b] < threshold && blocks.high[b] >= threshold)) continue;
                const BlockCut cut = block_sweep.cut(static_cast<Index>(b), values[i]);
                if (cut.polygon_count() == 0) continue;
                made[b].push_back({i, {}});
                sink.write(cut, made[b].back().part);
            }
    });
    if (stop.stop_requested()) return false;
    std::vector<std::vector<const Part*>> parts(values.size());
    for (const auto& of_block : made)
        for (const Made& one : of_block) parts[one.value].push_back(&one.part);
    out.resize(values.size());
    parallel_for(values.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sink.join(parts[i], out[i]);
    });
    return true;
}

template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const SliceSink&,
                    std::vector<SliceSink::Out>&, const StopToken&);
template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const SoupSink&,
                    std::vector<SoupSink::Out>&, const StopToken&);
template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const OutlineSink&,
                    std::vector<OutlineSink::Out>&, const StopToken&);
template bool sweep(const Topology&, const FaceMeshView&, const Field&, std::span<const double>, const SlabSink&,
                    std::vector<SlabSink::Out>&, const StopToken&);

} // namespace ciel
