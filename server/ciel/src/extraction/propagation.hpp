// Algorithm 2 of the paper: the active-edge list, kept from one nu to the next, and with it the cells around.
//
// Errata that this settles: step 2 as printed removes `succ` where `h` is meant, and turns around h's origin where the
// edges that leave its head are meant. Testing only "is not active already" lets an edge that was skipped by a jump be
// appended once per way that leads to it, which is exponential: a vertex is passed once, and passes all its edges on
// then. Going down is the same sweep with the order (value, id) reversed.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel {

// Serial, but for `settle`.
class Propagation {
public:
    // The next `reach` comes from below all values. Both must outlive the next call.
    void begin(const Topology& topology, const Field& field);

    // To nu, up or down. False when stopped. After that, and where there was no memory (it throws), the next one comes
    // from below all values: a list that was left half-way is worth nothing. Asks for no memory where another field of
    // the topology has been as far before.
    bool reach(double nu, const StopToken& stop);
    [[nodiscard]] float threshold() const { return threshold_; }

    // Blocks that may have active cells, ascending.
    void list_blocks(std::vector<Index>& out) const;
    // Brings a block's `cells` up to date; true when some may have changed sides since the last time. For different
    // blocks on any thread.
    bool settle(Index block);
    // Local cells that are active, ascending.
    [[nodiscard]] std::span<const Index> cells(Index block) const { return cells_[block]; }

    [[nodiscard]] std::size_t memory_bytes() const;

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
    [[nodiscard]] float value(Index vertex) const;
    template <class Keep, class Pass>
    bool propagate(const StopToken& stop, Keep&& keep, Pass&& pass);

    const Topology* topology_ = nullptr;
    const Field::Data* field_ = nullptr;
    bool arrived_ = false; // all below is of threshold_
    float threshold_ = 0;
    std::vector<HalfEdge> active_edges_;    // each from its low end to its high end
    std::vector<std::uint8_t> is_active_;   // by edge
    std::vector<std::uint8_t> is_low_;      // by vertex
    std::vector<Index> half_edges_;         // by cell
    std::vector<Index> low_half_edges_;     // by cell: those that leave a low vertex
    std::vector<std::uint8_t> is_listed_;   // by cell: is in cells_
    std::vector<std::vector<Index>> cells_; // by block: local cells, all active ones and perhaps others
    std::vector<std::uint8_t> is_stale_;    // by block: has cells that nu has passed a corner of
};

} // namespace ciel
