// The algorithms behind Query (paper, algorithms 1 and 2): each finds the blocks that a surface crosses and cuts them.
#pragma once

#include "blocks/block_cuts.hpp"
#include "ciel/extract.hpp"
#include "extraction/cut_block.hpp"

#include <optional>

namespace ciel {

// Not thread-safe; `update` uses all threads of the parallel loop. Borrows the topology and the current field.
class Cutter {
public:
    explicit Cutter(const Topology& topology) : topology_(topology), cut_(topology.block_count()) {}
    virtual ~Cutter() = default;

    virtual void set_field(const Field& field) = 0;
    void set_decider(Decider decider) {
        decider_ = decider;
        cut_.forget();
    }
    // Limits the next updates to some blocks; nullopt: all blocks. Throws Error if a block does not exist.
    void set_blocks(std::optional<std::span<const Index>> blocks);
    [[nodiscard]] bool has_all() const { return has_.empty(); }
    [[nodiscard]] bool has(Index block) const { return has_.empty() || has_[block] != 0; }
    // Updates the active blocks and their cuts to nu. Returns false when stopped; the Cutter stays usable.
    virtual bool update(double nu, const StopToken& stop) = 0;

    [[nodiscard]] std::span<const Index> active() const { return active_; } // blocks at the surface, ascending
    [[nodiscard]] BlockCuts& cut() { return cut_; }                         // cuts of the active blocks
    [[nodiscard]] virtual std::size_t memory_bytes() const;

protected:
    const Topology& topology_;
    Decider decider_ = Decider::isolate_high;
    BlockCuts cut_;
    std::vector<Index> active_;

private:
    std::vector<std::uint8_t> has_; // by block: 1 if it is cut; empty if all are
};

// Classifies each block's vertices against nu. A block keeps its cut while its classification is unchanged. Handles a
// step up or down, a jump and a new field alike. Blocks run in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology);
// The paper's Algorithm 2: propagates the active edges from one nu to the next, starting at sorted extrema. Propagation
// is serial; the blocks of the cells that it reaches are cut in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology);
// The paper's baseline: keeps nothing between values and visits every cell for each value. Blocks run in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_naive_cutter(const Topology& topology);

} // namespace ciel
