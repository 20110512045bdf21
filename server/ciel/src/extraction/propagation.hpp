// Algorithm 2 of the paper: keeps the active edges, and the cells around them, from one nu to the next. Corrects two
// errors of the printed algorithm. Step 2 removes `succ` instead of `h`, and turns around the origin of h instead of
// its head. The test "is not active already" takes exponential time, because an edge that a jump skips is appended once
// for each path to the edge. Here, a sweep passes each vertex once. A sweep down reverses the order (value, id).
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel::detail {

// Not thread-safe, except `settle`.
class Propagation {
public:
    // The topology and the field must live until the next call of `begin`. The next `reach` starts below all values.
    void begin(const Topology& topology, const Field& field);

    // Moves the active edges to nu. Returns false when `stop` was requested. Throws when out of memory. In both cases
    // the next call starts below all values.
    bool reach(double nu, const StopToken& stop);
    [[nodiscard]] double threshold() const { return threshold_; }

    void list_blocks(std::vector<Index>& out) const;
    // Updates the result of `cells(block)`. Returns true when nu has passed a vertex of the block's cells since the
    // last call. May be called for different blocks on different threads at the same time.
    bool settle(Index block);
    // Returns the local ids of the block's active cells, ascending. REQUIRES: settle(block) was called after `reach`.
    [[nodiscard]] std::span<const Index> cells(Index block) const { return cells_[block]; }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    enum class Way { up, down };

    void restart();
    bool sweep_up(double threshold, const StopToken& stop);
    bool sweep_down(double threshold, const StopToken& stop);
    template <Way way>
    void pass(Index vertex);
    template <Way way>
    void turn(HalfEdge h);
    [[nodiscard]] bool below(Index a, Index b) const;
    [[nodiscard]] double value(Index vertex) const;
    template <class Keep, class Pass>
    bool propagate(const StopToken& stop, Keep&& keep, Pass&& pass);

    const Topology* topology_ = nullptr;
    const Field::Data* field_ = nullptr;
    bool arrived_ = false; // whether the members below are complete for threshold_
    double threshold_ = 0;
    std::vector<HalfEdge> active_edges_;    // half-edges, each from the low end to the high end of its edge
    std::vector<std::uint8_t> is_active_;   // by edge: 1 if in active_edges_
    std::vector<std::uint8_t> is_low_;      // by vertex: 1 if the value is below nu
    std::vector<Index> half_edges_;         // by cell: number of half-edges
    std::vector<Index> low_half_edges_;     // by cell: number of half-edges that leave a low vertex
    std::vector<std::uint8_t> is_listed_;   // by cell: 1 if in cells_
    std::vector<std::vector<Index>> cells_; // by block: local ids of the active cells; before settle, also others
    std::vector<std::uint8_t> is_stale_;    // by block: 1 if nu has passed a vertex since the last settle
};

} // namespace ciel::detail
