// The algorithms behind Query (paper, algorithms 1 and 2): each finds out which blocks a surface crosses and cuts them.
#pragma once

#include "ciel/extract.hpp"
#include "extraction/cut_block.hpp"

namespace ciel {

// One caller at a time, whose update uses all threads of the parallel loop. Borrows the topology, and the field until
// the next one.
class Cutter {
public:
    explicit Cutter(const Topology& topology) : topology_(topology), cut_(topology.block_count()) {}
    virtual ~Cutter() = default;

    virtual void set_field(const Field& field) = 0;
    void set_decider(Decider decider) {
        decider_ = decider;
        for (ActiveBlock& cut : cut_) cut.known = false;
    }
    // Brings `active` and their cuts to nu. False when stopped; the next update starts from what is known.
    virtual bool update(double nu, const StopToken& stop) = 0;

    [[nodiscard]] std::span<const Index> active() const { return active_; } // crossed blocks, ascending
    [[nodiscard]] std::span<ActiveBlock> cut() { return cut_; }             // by block
    [[nodiscard]] virtual std::size_t memory_bytes() const;

protected:
    const Topology& topology_;
    Decider decider_ = Decider::isolate_high;
    std::vector<ActiveBlock> cut_;
    std::vector<Index> active_;
};

// Design: each block's vertices are classified against nu; a block whose classification has not changed keeps its cut.
// The same for a step up or down, a jump, a new field; blocks in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology);
// The paper's Algorithm 2: the active edges are propagated from one nu to the next, from sorted extrema. The
// propagation is serial; the blocks whose cells it has reached are cut in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology);
// The paper's baseline: nothing is kept, every cell is looked at each time; blocks in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_naive_cutter(const Topology& topology);

} // namespace ciel
