// InnerFaces: the faces inside the mesh that bound a set of cells. Not in the paper.
#pragma once

#include "blocks/cell_loops.hpp"
#include "ciel/block_ranges.hpp"
#include "ciel/topology.hpp"

#include <functional>

namespace ciel::detail {

// The faces between a kept cell and a cell that is not kept. `kept`: one flag per cell, not 0 if the cell is kept.
// `boxes`: the result of block_boxes for the positions. The arguments must outlive the object.
class InnerFaces {
public:
    struct OfBlock {
        CellLoops loops;         // wound outwards from the kept cell
        std::vector<Index> cell; // by face: the kept cell
    };

    InnerFaces(const Topology& topology, const BlockBoxes& boxes, std::span<const std::uint8_t> kept);

    // Calls f for one block after another, on this thread. Throws Error when a record is damaged.
    void for_blocks(const std::function<void(const OfBlock&)>& f) const;

private:
    enum class Has : std::uint8_t { no_cell, some, all }; // which cells of a block are kept

    [[nodiscard]] std::vector<Index> blocks_to_read() const;
    [[nodiscard]] bool boxes_touch(Index a, Index b) const;
    void find_in(Index b, OfBlock& found) const;
    void find_in(Index b, const Block& block, const StandardSection& section, OfBlock& found) const;
    template <class Local>
    void find_in(Index b, const Block& block, const PolyhedralSection<Local>& polyhedra, OfBlock& found) const;
    [[nodiscard]] bool ends_at(HalfEdge h) const;

    const Topology& topology_;
    const Topology::Blocks& blocks_;
    const BlockBoxes& boxes_;
    std::span<const std::uint8_t> kept_;
    std::vector<Has> has_; // by block
};

} // namespace ciel::detail
