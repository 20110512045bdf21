// Algorithm 2 of the paper: the active-edge list, kept from one nu to the next.
//
// Errata that this settles: step 2 as printed removes `succ` where `h` is meant, and turns around h's origin where the
// edges that leave its head are meant. Testing only "is not active already" lets an edge that was skipped by a jump be
// appended once per way that leads to it, which is exponential: a vertex is passed once, and passes all its edges on
// then. Going down is the same sweep with the order (value, id) reversed.
#include "ciel/cutter.hpp"
#include "ciel/field_blocks.hpp"

#include <algorithm>
#include <cmath>

namespace ciel {

namespace {

class PropagationCutter : public Cutter {
public:
    using Cutter::Cutter;

    void set_field(const Field& field) override {
        field_ = &field.blocks();
        restart();
    }
    bool update(double nu, const StopToken& stop) override;
    [[nodiscard]] std::size_t memory_bytes() const override;

private:
    // A cell around an active edge.
    struct Touch {
        Index block, cell;                              // the last is local
        auto operator<=>(const Touch&) const = default; // NOLINT(modernize-use-nullptr): takes <=> for a 0
    };

    void restart();
    bool sweep_up(float threshold, const StopToken& stop);
    bool sweep_down(float threshold, const StopToken& stop);
    void pass_up(Index vertex);
    void pass_down(Index vertex);
    [[nodiscard]] bool below(Index a, Index b) const;
    [[nodiscard]] float value(Index vertex) const { return field_->values[vertex]; }
    template <class Keep, class Pass>
    bool propagate(const StopToken& stop, Keep&& keep, Pass&& pass);
    void turn_around_edges();
    void update_block(std::span<const Touch> touches, double nu);

    const Field::Blocks* field_ = nullptr;
    float threshold_ = -std::numeric_limits<float>::infinity();
    std::vector<HalfEdge> active_edges_;  // each from its low end to its high end
    std::vector<std::uint8_t> is_active_; // by edge
    std::vector<std::uint8_t> is_low_;    // by vertex
    std::vector<Touch> touches_;
    std::vector<Index> cells_;
};

void PropagationCutter::restart() {
    threshold_ = -std::numeric_limits<float>::infinity();
    active_edges_.clear();
    is_active_.assign(topology_.counts().edges, 0);
    is_low_.assign(topology_.counts().vertices, 0);
}

bool PropagationCutter::below(Index a, Index b) const { return value(a) != value(b) ? value(a) < value(b) : a < b; }

// Appends the edges that climb from a vertex.
void PropagationCutter::pass_up(Index vertex) {
    is_low_[vertex] = 1;
    const HalfEdge start = topology_.half_edge_of_vertex(vertex);
    HalfEdge h = start;
    do {
        const Index head = topology_.vertex(h), edge = topology_.edge(h);
        if (!is_active_[edge] && std::isfinite(value(head)) && below(vertex, head)) {
            is_active_[edge] = 1;
            active_edges_.push_back(h);
        }
        h = topology_.next_around_vertex(h);
    } while (h != start);
}

// Appends the edges that climb to a vertex.
void PropagationCutter::pass_down(Index vertex) {
    is_low_[vertex] = 0;
    const HalfEdge start = topology_.half_edge_of_vertex(vertex);
    HalfEdge h = start;
    do {
        const Index foot = topology_.vertex(h), edge = topology_.edge(h);
        if (!is_active_[edge] && std::isfinite(value(foot)) && below(foot, vertex)) {
            is_active_[edge] = 1;
            active_edges_.push_back(topology_.mate_face(h));
        }
        h = topology_.next_around_vertex(h);
    } while (h != start);
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
        if (!is_low_[v]) pass_up(v);
    }
    return propagate(
        stop, [&](HalfEdge h) { return value(topology_.vertex(h)) >= threshold; },
        [&](HalfEdge h) {
            const Index head = topology_.vertex(h);
            if (!is_low_[head]) pass_up(head);
        });
}

bool PropagationCutter::sweep_down(float threshold, const StopToken& stop) {
    for (const Index v : field_->maxima) {
        if (value(v) < threshold) break;
        if (is_low_[v]) pass_down(v);
    }
    const auto foot = [&](HalfEdge h) { return topology_.vertex(topology_.mate_face(h)); };
    return propagate(
        stop, [&](HalfEdge h) { return value(foot(h)) < threshold; },
        [&](HalfEdge h) {
            if (is_low_[foot(h)]) pass_down(foot(h));
        });
}

// Rotating by mate_face and mate_polyhedron would miss cells where an edge has several fans (non-manifold) or a fan
// starts at the boundary; the list of its origin holds them all.
void PropagationCutter::turn_around_edges() {
    const Topology::Blocks& blocks = topology_.blocks();
    touches_.clear();
    for (const HalfEdge start : active_edges_) {
        const Index edge = topology_.edge(start);
        HalfEdge h = start;
        do {
            if (topology_.edge(h) == edge) {
                const Index b = blocks.block_of(h);
                touches_.push_back({b, topology_.cell(h) - blocks.block[b].cell_begin});
            }
            h = topology_.next_around_vertex(h);
        } while (h != start);
    }
    std::ranges::sort(touches_);
    touches_.erase(std::unique(touches_.begin(), touches_.end()), touches_.end());
}

void PropagationCutter::update_block(std::span<const Touch> touches, double nu) {
    const Index b = touches.front().block;
    cells_.clear();
    for (const Touch& touch : touches) cells_.push_back(touch.cell);
    const std::span<const float> values = field_->of_block(b);
    CutScratch& scratch = scratch_of_this_thread();
    (void)classify(values, threshold_, scratch, cut_[b]);
    cut_cells(topology_.blocks().block[b], {values, field_->gaps[b] != 0, threshold_, nu, decider_, {}}, cells_,
              scratch, cut_[b]);
    active_.push_back(b);
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
    turn_around_edges();
    for (std::size_t begin = 0, end; begin < touches_.size(); begin = end) {
        if (stop.stop_requested()) return false;
        for (end = begin; end < touches_.size() && touches_[end].block == touches_[begin].block;) ++end;
        update_block(std::span(touches_).subspan(begin, end - begin), nu);
    }
    return true;
}

std::size_t PropagationCutter::memory_bytes() const {
    return Cutter::memory_bytes() + active_edges_.capacity() * sizeof(HalfEdge) + is_active_.capacity() +
           is_low_.capacity() + touches_.capacity() * sizeof(Touch) + cells_.capacity() * sizeof(Index);
}

} // namespace

std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology) {
    return std::make_unique<PropagationCutter>(topology);
}

} // namespace ciel
