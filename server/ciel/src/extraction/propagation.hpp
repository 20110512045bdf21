// Algorithm 2 of the paper: the active-edge list and the cells around it, kept from one nu to the next.
//
// Errata corrected here: step 2 as printed removes `succ` instead of `h`, and turns around h's origin instead of its
// head. Testing only "is not active already" is exponential: an edge that a jump skipped is appended once for each path
// to it. So each vertex is passed once and passes all its edges on. Going down is the same sweep with (value, id)
// reversed.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel {

// Serial, except `settle`.
class Propagation {
public:
    // The next `reach` starts below all values. Borrows both arguments until the next `begin`.
    void begin(const Topology& topology, const Field& field);

    // Moves the list to nu, up or down. Returns false when stopped; throws when out of memory. The next call then
    // starts below all values, because an incomplete list is useless. Allocates nothing if an earlier field got as far.
    bool reach(double nu, const StopToken& stop);
    [[nodiscard]] float threshold() const { return threshold_; }

    // Blocks that may have active cells, ascending.
    void list_blocks(std::vector<Index>& out) const;
    // Updates `cells` of a block. Returns true when some cells may have changed sides since the last call. Different
    // blocks may be settled on different threads.
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
    bool arrived_ = false; // the members below are valid for threshold_
    float threshold_ = 0;
    std::vector<HalfEdge> active_edges_;    // each from its low end to its high end
    std::vector<std::uint8_t> is_active_;   // by edge
    std::vector<std::uint8_t> is_low_;      // by vertex
    std::vector<Index> half_edges_;         // by cell
    std::vector<Index> low_half_edges_;     // by cell: number that leave a low vertex
    std::vector<std::uint8_t> is_listed_;   // by cell: is in cells_
    std::vector<std::vector<Index>> cells_; // by block: local cells, all active ones and perhaps others
    std::vector<std::uint8_t> is_stale_;    // by block: nu has passed a corner of some cell
};

} // namespace ciel
