#include "ciel/sweep.hpp"

#include "blocks/load_vertices.hpp"
#include "ciel/of_this_thread.hpp"
#include "ciel/parallel.hpp"
#include "extraction/cut_block.hpp"
#include "extraction/edge_points.hpp"
#include "extraction/propagation.hpp"
#include "fields/field_data.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace ciel {

using namespace detail;

namespace {

// Cuts single blocks. One object serves many blocks. Each thread needs its own object.
class BlockSlicer {
public:
    // Returns the cut of block b at nu, which is valid until the next call. `cells`: local ids of the cells that may be
    // active; nullopt: all cells.
    [[nodiscard]] BlockPolygons cut(const FaceMeshView& mesh, const Field::Data& field, Extraction how, Index b,
                                    double nu, std::optional<std::span<const Index>> cells) {
        const Block& block = field.topology->blocks().cells(b);
        const ValuesView values = field.of_block(b);
        BlockValues in{
            values, field.has_gaps(b), field.threshold(nu), nu, how.decider, {}, how.algorithm == Algorithm::naive};
        if (how.algorithm == Algorithm::signatures) in.ranges = field.ranges.of(block, b, values);
        CutScratch& scratch = of_this_thread<CutScratch>();
        if (cells)
            cut_cells_alone(block, in, *cells, scratch, cut_);
        else
            cut_block_alone(block, in, scratch, cut_);
        points_.resize(scratch.met_count);
        positions_.resize(scratch.met_count);
        values.with([&](const auto& all) {
            for (std::size_t i = 0; i < points_.size(); ++i) points_[i] = edge_point(block, all, scratch.ends[i], nu);
        });
        load_vertices(mesh.loader, b, block);
        mesh.positions.with([&, shift = mesh.surface_shift()](const auto& positions) {
            for (std::size_t i = 0; i < points_.size(); ++i) positions_[i] = position_of(points_[i], positions, shift);
        });
        return {points_, positions_, cut_.polygon_end, cut_.polygon_edge, cut_.polygon_cell, block.cell_begin};
    }

private:
    ActiveBlock cut_;
    std::vector<EdgePoint> points_;
    std::vector<Vec3f> positions_;
};

struct Pass {
    const Topology& topology;
    const FaceMeshView& mesh;
    const Field& field;
    std::span<const double> values;
    const OnCut& on_cut;
    Extraction how;
    SweepScratch& scratch;
    const StopToken& stop;

    void cut(Index b, std::size_t value, std::optional<std::span<const Index>> cells) const {
        const BlockPolygons cut = of_this_thread<BlockSlicer>().cut(mesh, field.data(), how, b, values[value], cells);
        if (cut.polygon_count() != 0) on_cut(value, b, cut);
    }

    // For the algorithms signatures and naive.
    void cut_blocks() const {
        const Field::Data& blocks = field.data();
        parallel_for(topology.block_count(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end && !stop.stop_requested(); ++b)
                for (std::size_t i = 0; i < values.size(); ++i) {
                    const double threshold = blocks.threshold(values[i]);
                    if (how.algorithm == Algorithm::naive || blocks.crosses(static_cast<Index>(b), threshold))
                        cut(static_cast<Index>(b), i, {});
                }
        });
    }

    // For the algorithm propagation. Returns false when `stop` was requested.
    bool propagate() const {
        if (!scratch.propagation) scratch.propagation = std::make_shared<Propagation>();
        Propagation& propagation = *scratch.propagation;
        propagation.begin(topology, field);
        scratch.order.resize(values.size());
        std::iota(scratch.order.begin(), scratch.order.end(), std::size_t{0});
        std::ranges::sort(scratch.order, {},
                          [&](std::size_t i) { return std::pair(field.data().threshold(values[i]), i); });
        for (const std::size_t i : scratch.order) {
            if (!propagation.reach(values[i], stop)) return false;
            propagation.list_blocks(scratch.reached);
            parallel_for(scratch.reached.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end && !stop.stop_requested(); ++k) {
                    const Index b = scratch.reached[k];
                    propagation.settle(b);
                    if (!propagation.cells(b).empty()) cut(b, i, propagation.cells(b));
                }
            });
        }
        return true;
    }
};

} // namespace

bool sweep(const Topology& topology, const FaceMeshView& mesh, const Field& field, std::span<const double> values,
           const OnCut& on_cut, SweepScratch& scratch, const StopToken& stop, Extraction extraction) {
    if (!field.data().is_of(topology))
        fail("the field belongs to another topology; make the field from the topology of the sweep");
    if (mesh.vertex_count() != topology.counts().vertices || mesh.cell_count() != topology.counts().cells)
        fail("the mesh and the topology differ; pass the mesh from which the topology was built");
    const Pass pass{topology, mesh, field, values, on_cut, extraction, scratch, stop};
    if (extraction.algorithm != Algorithm::propagation)
        pass.cut_blocks();
    else if (!pass.propagate())
        return false;
    return !stop.stop_requested();
}

} // namespace ciel
