// The algorithms behind Query (paper, algorithms 1 and 2). Each finds the blocks that a surface crosses, and cuts them.
#pragma once

#include "blocks/block_cuts.hpp"
#include "ciel/extract.hpp"
#include "extraction/cut_block.hpp"

#include <optional>

namespace ciel::detail {

// Not thread-safe. The topology and the current field must outlive the Cutter.
class Cutter {
public:
    explicit Cutter(const Topology& topology) : topology_(topology), cut_(topology.block_count()) {}
    virtual ~Cutter() = default;

    virtual void set_field(const Field& field) = 0;
    void set_decider(Decider decider) {
        decider_ = decider;
        cut_.forget();
    }
    // Limits the next updates to some blocks; nullopt: all blocks. Throws Error when a block does not exist.
    void set_blocks(std::optional<std::span<const Index>> blocks);
    [[nodiscard]] bool has_all() const { return has_.empty(); }
    [[nodiscard]] bool has(Index block) const { return has_.empty() || has_[block] != 0; }
    // Cuts the blocks that nu crosses. Returns false when `stop` was requested; the Cutter stays usable.
    virtual bool update(double nu, const StopToken& stop) = 0;

    [[nodiscard]] std::span<const Index> active() const { return active_; } // blocks that nu crosses, ascending
    [[nodiscard]] BlockCuts& cut() { return cut_; }                         // cuts of the active blocks
    [[nodiscard]] virtual std::size_t memory_bytes() const;

protected:
    const Topology& topology_;
    Decider decider_ = Decider::isolate_high;
    BlockCuts cut_;
    std::vector<Index> active_;

private:
    std::vector<std::uint8_t> has_; // by block: 1 if the block may be cut; empty if all blocks may
};

// Each block keeps its cut while the same vertices are high. Blocks run in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_signature_cutter(const Topology& topology);
// The paper's Algorithm 2: moves the active edges from one nu to the next. Only the cuts of blocks run in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_propagation_cutter(const Topology& topology);
// The paper's baseline: visits every cell for each nu. Blocks run in parallel.
[[nodiscard]] std::unique_ptr<Cutter> make_naive_cutter(const Topology& topology);

} // namespace ciel::detail
