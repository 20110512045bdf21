#include "blocks/inner_faces.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <array>

namespace ciel::detail {

InnerFaces::InnerFaces(const Topology& topology, const BlockBoxes& boxes, std::span<const std::uint8_t> kept)
    : topology_(topology), blocks_(topology.blocks()), boxes_(boxes), kept_(kept), has_(blocks_.count()) {
    if (kept.size() != topology.counts().cells || boxes[0].low.size() != topology.block_count())
        fail("the flags of the cells or the boxes do not fit the topology; pass one flag per cell and one box per "
             "block");
    parallel_for(has_.size(), 16, [this](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            const auto cells =
                kept_.subspan(blocks_.numbers.cell[b], blocks_.numbers.cell[b + 1] - blocks_.numbers.cell[b]);
            const bool some = std::ranges::any_of(cells, [](std::uint8_t flag) { return flag != 0; });
            const bool every = std::ranges::none_of(cells, [](std::uint8_t flag) { return flag == 0; });
            has_[b] = !some ? Has::no_cell : every ? Has::all : Has::some;
        }
    });
}

void InnerFaces::for_blocks(const std::function<void(const OfBlock&)>& f) const {
    const std::vector<Index> blocks = blocks_to_read();
    constexpr std::size_t at_once = 64; // blocks searched at a time; limits the memory for found faces
    for (std::size_t first = 0; first < blocks.size(); first += at_once) {
        std::array<OfBlock, at_once> found;
        parallel_for(std::min(at_once, blocks.size() - first), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) find_in(blocks[first + i], found[i]);
        });
        std::ranges::for_each(found, f);
    }
}

// Returns the blocks with cells of both kinds, and the blocks with only kept cells whose box touches the box of a block
// with a cell that is not kept.
std::vector<Index> InnerFaces::blocks_to_read() const {
    std::vector<Index> others; // blocks with a cell that is not kept, sorted by the low x of their box
    double widest = 0;
    for (Index b = 0; b < blocks_.count(); ++b) {
        if (has_[b] == Has::all) continue;
        others.push_back(b);
        widest = std::max(widest, boxes_[0].high[b] - boxes_[0].low[b]);
    }
    const auto low = [this](Index b) { return boxes_[0].low[b]; };
    std::ranges::sort(others, {}, low);
    const auto has_neighbor = [&](Index b) {
        auto other = std::ranges::lower_bound(others, boxes_[0].low[b] - widest, {}, low);
        const auto end = std::ranges::upper_bound(others, boxes_[0].high[b], {}, low);
        return std::any_of(other, end, [&](Index of) { return boxes_touch(b, of); });
    };
    std::vector<Index> found;
    for (Index b = 0; b < blocks_.count(); ++b)
        if (has_[b] == Has::some || (has_[b] == Has::all && has_neighbor(b))) found.push_back(b);
    return found;
}

bool InnerFaces::boxes_touch(Index a, Index b) const {
    return std::ranges::all_of(
        boxes_, [&](const BlockRanges& axis) { return axis.low[a] <= axis.high[b] && axis.low[b] <= axis.high[a]; });
}

void InnerFaces::find_in(Index b, OfBlock& found) const {
    const Block& block = blocks_.cells(b);
    for (const StandardSection& section : block.standard) find_in(b, block, section, found);
    block.with([&](const auto& polyhedra) { find_in(b, block, polyhedra, found); });
}

void InnerFaces::find_in(Index b, const Block& block, const StandardSection& section, OfBlock& found) const {
    const StandardShape& shape = *section.shape;
    for (Index i = 0; i < section.count(); ++i) {
        const Index cell = block.cell(section.local_cell(i));
        if (kept_[cell] == 0) continue;
        for (std::size_t face = 0; face < shape.faces; ++face) {
            const Index first = shape.face_begin[face];
            if (!ends_at(half_edge_in(b, section.half_edge_begin + i * shape.half_edges + first))) continue;
            add_face(block, section, i, face, found.loops);
            found.cell.push_back(cell);
        }
    }
}

template <class Local>
void InnerFaces::find_in(Index b, const Block& block, const PolyhedralSection<Local>& polyhedra, OfBlock& found) const {
    std::size_t corners = 0;
    for (Index i = 0; i < polyhedra.count(); ++i) {
        const Index cell = block.cell(polyhedra.local_cell(i));
        if (kept_[cell] == 0) continue;
        for (const Local& entry : polyhedra.faces_of(i)) {
            const Index face_and_side = read_once(entry), side = face_and_side % 2;
            const auto loop = corners_of_face(polyhedra, face_and_side / 2);
            corners += loop.size();
            if (corners > polyhedra.half_edge_count()) refuse_changed("a cell has more corners than its block");
            if (loop.size() < 3 ||
                !ends_at(half_edge_in(b, polyhedra.half_edge_begin + polyhedra.half_edge(loop.begin, side))))
                continue;
            add_face(block, polyhedra, loop, side, found.loops);
            found.cell.push_back(cell);
        }
    }
}

// Returns whether the cell on the other side of the half-edge's face exists and is not kept.
bool InnerFaces::ends_at(HalfEdge h) const {
    const HalfEdge mate = topology_.mate_polyhedron(h);
    if (mate == no_half_edge) return false;
    const Has of_block = has_[block_of(mate)];
    return of_block == Has::no_cell || (of_block == Has::some && kept_[topology_.cell(mate)] == 0);
}

} // namespace ciel::detail
