// Algorithm 2 of the paper: the active-edge list, kept from one nu to the next, and with it the cells around.
//
// Errata that this settles: step 2 as printed removes `succ` where `h` is meant, and turns around h's origin where the
// edges that leave its head are meant. Testing only "is not active already" lets an edge that was skipped by a jump be
// appended once per way that leads to it, which is exponential: a vertex is passed once, and passes all its edges on
// then. Going down is the same sweep with the order (value, id) reversed.
#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

namespace {

class PropagationCutter : public Cutter {
public:
    explicit PropagationCutter(const Topology& topology);

    void set_field(const Field& field) override {
        field_ = &field.blocks();
        restart();
    }
    bool update(double nu, const StopToken& stop) override;
    [[nodiscard]] std::size_t memory_bytes() const override;

private:
    enum class Way { up, down };

    void restart();
    bool sweep_up(float threshold, const StopToken& stop);
    bool sweep_down(float threshold, const StopToken& stop);
    template <Way way>
    void pass(Index vertex);
    template <Way way>
    void turn(HalfEdge h);
    [[nodiscard]] bool below(Index a, Index b) const;
    [[nodiscard]] float value(Index vertex) const { return field_->values[vertex]; }
    template <class Keep, class Pass>
    bool propagate(const StopToken& stop, Keep&& keep, Pass&& pass);
    void drop_inactive_cells(Index b);
    void update_block(Index b, double nu);

    const Field::Blocks* field_ = nullptr;
    float threshold_ = -std::numeric_limits<float>::infinity();
    std::vector<HalfEdge> active_edges_;    // each from its low end to its high end
    std::vector<std::uint8_t> is_active_;   // by edge
    std::vector<std::uint8_t> is_low_;      // by vertex
    std::vector<Index> half_edges_;         // by cell
    std::vector<Index> low_half_edges_;     // by cell: those that leave a low vertex
    std::vector<std::uint8_t> is_listed_;   // by cell: is in cells_
    std::vector<std::vector<Index>> cells_; // by block: local cells, all active ones and perhaps others
};

std::vector<Index> half_edges_by_cell(const Topology& topology) {
    std::vector<Index> out(topology.counts().cells);
    for (const Block& block : topology.blocks().block) {
        for (const StandardSection& section : block.standard)
            for (Index i = 0; i < section.count(); ++i)
                out[block.cell_begin + section.local_cell(i)] = section.shape->half_edges;
        block.with([&](const auto& arrays) {
            const auto& polyhedra = arrays.polyhedra;
            for (Index i = 0; i < polyhedra.count(); ++i)
                for (const Index ref : polyhedra.faces_of(i))
                    out[block.cell_begin + polyhedra.local_cell(i)] +=
                        polyhedra.face_begin[ref / 2 + 1] - polyhedra.face_begin[ref / 2];
        });
    }
    return out;
}

PropagationCutter::PropagationCutter(const Topology& topology)
    : Cutter(topology), half_edges_(half_edges_by_cell(topology)), cells_(topology.block_count()) {}

void PropagationCutter::restart() {
    threshold_ = -std::numeric_limits<float>::infinity();
    active_edges_.clear();
    is_active_.assign(topology_.counts().edges, 0);
    is_low_.assign(topology_.counts().vertices, 0);
    low_half_edges_.assign(half_edges_.size(), 0);
    is_listed_.assign(half_edges_.size(), 0);
    for (std::vector<Index>& cells : cells_) cells.clear();
    for (CutBlock& cut : cut_) cut.known = false;
}

bool PropagationCutter::below(Index a, Index b) const { return value(a) != value(b) ? value(a) < value(b) : a < b; }

// nu passes a vertex: the edges that go on from there become active. Rotating by mate_face and mate_polyhedron would
// miss cells where an edge has several fans (non-manifold) or a fan starts at the boundary; the vertex's list holds
// them all.
template <PropagationCutter::Way way>
void PropagationCutter::pass(Index vertex) {
    is_low_[vertex] = way == Way::up ? 1 : 0;
    const HalfEdge start = topology_.half_edge_of_vertex(vertex);
    HalfEdge h = start;
    do {
        const Index other = topology_.vertex(h), edge = topology_.edge(h);
        if (!is_active_[edge] && std::isfinite(value(other)) &&
            (way == Way::up ? below(vertex, other) : below(other, vertex))) {
            is_active_[edge] = 1;
            active_edges_.push_back(way == Way::up ? h : topology_.mate_face(h));
        }
        turn<way>(h);
        h = topology_.next_around_vertex(h);
    } while (h != start);
}

// The cell of a half-edge whose origin is passed. The paper turns around each active edge for each surface; what was
// found is kept here, so a step costs what it passes.
template <PropagationCutter::Way way>
void PropagationCutter::turn(HalfEdge h) {
    const Index b = topology_.blocks().block_of(h), cell = topology_.cell(h);
    way == Way::up ? ++low_half_edges_[cell] : --low_half_edges_[cell];
    cut_[b].known = false;
    if (is_listed_[cell]) return;
    is_listed_[cell] = 1;
    cells_[b].push_back(cell - topology_.blocks().block[b].cell_begin);
}

// Step 2. Appended edges are looked at in the same traversal: small cells that nu has skipped pass it on.
template <class Keep, class Pass>
bool PropagationCutter::propagate(const StopToken& stop, Keep&& keep, Pass&& pass) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < active_edges_.size(); ++i) {
        if (i % 4096 == 0 && stop.stop_requested()) return false;
        const HalfEdge h = active_edges_[i];
        if (keep(h)) {
            active_edges_[kept++] = h;
        } else {
            is_active_[topology_.edge(h)] = 0;
            pass(h);
        }
    }
    active_edges_.resize(kept);
    return true;
}

bool PropagationCutter::sweep_up(float threshold, const StopToken& stop) {
    for (const Index v : field_->minima) {
        if (value(v) >= threshold) break;
        if (!is_low_[v]) pass<Way::up>(v);
    }
    return propagate(
        stop, [&](HalfEdge h) { return value(topology_.vertex(h)) >= threshold; },
        [&](HalfEdge h) {
            const Index head = topology_.vertex(h);
            if (!is_low_[head]) pass<Way::up>(head);
        });
}

bool PropagationCutter::sweep_down(float threshold, const StopToken& stop) {
    for (const Index v : field_->maxima) {
        if (value(v) < threshold) break;
        if (is_low_[v]) pass<Way::down>(v);
    }
    const auto foot = [&](HalfEdge h) { return topology_.vertex(topology_.mate_face(h)); };
    return propagate(
        stop, [&](HalfEdge h) { return value(foot(h)) < threshold; },
        [&](HalfEdge h) {
            if (is_low_[foot(h)]) pass<Way::down>(foot(h));
        });
}

void PropagationCutter::drop_inactive_cells(Index b) {
    const Index begin = topology_.blocks().block[b].cell_begin;
    std::erase_if(cells_[b], [&](Index local) {
        const Index cell = begin + local;
        const bool is_active = low_half_edges_[cell] != 0 && low_half_edges_[cell] != half_edges_[cell];
        if (!is_active) is_listed_[cell] = 0;
        return !is_active;
    });
    std::ranges::sort(cells_[b]);
}

void PropagationCutter::update_block(Index b, double nu) {
    CutBlock& cut = cut_[b];
    if (cut.known) return;
    drop_inactive_cells(b);
    if (cells_[b].empty()) return;
    const std::span<const float> values = field_->of_block(b);
    CutScratch& scratch = scratch_of_this_thread();
    (void)classify(values, threshold_, scratch, cut);
    cut_cells(topology_.blocks().block[b], {values, field_->gaps[b] != 0, threshold_, nu, decider_, {}}, cells_[b],
              scratch, cut);
    cut.known = !cut.decided;
}

bool PropagationCutter::update(double nu, const StopToken& stop) {
    const float threshold = threshold_of(nu);
    active_.clear();
    field_->make_extrema();
    const bool done = threshold >= threshold_ ? sweep_up(threshold, stop) : sweep_down(threshold, stop);
    if (!done) {
        restart(); // a list that was left half-way is worth nothing
        return false;
    }
    threshold_ = threshold;
    for (Index b = 0; b < cut_.size(); ++b)
        if (!cells_[b].empty()) active_.push_back(b);
    parallel_for(active_.size(), 2, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i) update_block(active_[i], nu);
    });
    std::erase_if(active_, [this](Index b) { return cells_[b].empty(); });
    return !stop.stop_requested();
}

std::size_t PropagationCutter::memory_bytes() const {
    std::size_t bytes = Cutter::memory_bytes() + active_edges_.capacity() * sizeof(HalfEdge) + is_active_.capacity() +
                        is_low_.capacity() + is_listed_.capacity() +
                        (half_edges_.capacity() + low_half_edges_.capacity()) * sizeof(Index);
    for (const std::vector<Index>& cells : cells_)
        bytes += sizeof(std::vector<Index>) + cells.capacity() * sizeof(Index);
    return bytes;
}

} // namespace

std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology) {
    return std::make_unique<PropagationCutter>(topology);
}

} // namespace ciel
