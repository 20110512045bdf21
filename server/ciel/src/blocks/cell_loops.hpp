// The faces of a block's cells as loops of vertices (paper, section 2.2: what walks around a cell's faces would find).
#pragma once

#include "blocks/block.hpp"

namespace ciel {

// The faces of one cell, wound outwards. Vertices are those of the mesh.
struct CellLoops {
    std::vector<Index> begin{0}; // by face: its first vertex in `vertex`; one more at the end
    std::vector<Index> vertex;

    [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
    [[nodiscard]] std::span<const Index> face(std::size_t i) const {
        return std::span(vertex).subspan(begin[i], begin[i + 1] - begin[i]);
    }
    void clear() {
        begin.resize(1);
        vertex.clear();
    }
    void end_face() { begin.push_back(static_cast<Index>(vertex.size())); }
};

// Replaces `loops` by those of the i-th cell of a section.
inline void read_loops(const Block& block, const StandardSection& section, Index i, CellLoops& loops) {
    const StandardShape& shape = *section.shape;
    loops.clear();
    for (std::size_t face = 0; face < shape.faces; ++face) {
        for (std::size_t h = shape.face_begin[face]; h < shape.face_begin[face + 1]; ++h)
            loops.vertex.push_back(block.vertex(read_once(section.vertex[i * shape.corners + shape.origin[h]])));
        loops.end_face();
    }
}

template <class Local, template <class> class Array>
void read_loops(const Block& block, const PolyhedralSection<Local, Array>& section, Index i, CellLoops& loops) {
    loops.clear();
    for (const Local& entry : section.faces_of(i)) {
        const Index face_and_side = read_once(entry);
        if (face_and_side / 2 >= section.face_count()) refuse_changed("a cell has a face that does not exist");
        const auto loop = section.loop(face_and_side / 2);
        if (loop.end > section.vertex.size()) refuse_changed("a face does not have its corners");
        if (loops.vertex.size() + loop.size() > section.half_edge_count())
            refuse_changed("a cell has more corners than its block");
        const auto begin = static_cast<std::ptrdiff_t>(loops.vertex.size());
        for (Index corner = loop.begin; corner < loop.end; ++corner)
            loops.vertex.push_back(block.vertex(read_once(section.vertex[corner])));
        if (face_and_side % 2 == 1) std::reverse(loops.vertex.begin() + begin, loops.vertex.end());
        loops.end_face();
    }
}

// Calls f(cell of the mesh, loops) for each cell of the block, section by section. The loops are replaced by the next.
// Ends, whatever the records hold: all cells together have no more corners than the block has half-edges.
template <class F>
void for_cells(const Block& block, CellLoops& loops, F&& f) {
    std::size_t corners = 0;
    const auto for_section = [&](const auto& section) {
        for (Index i = 0; i < section.count(); ++i) {
            read_loops(block, section, i, loops);
            corners += loops.vertex.size();
            if (corners > block.half_edge_count) refuse_changed("its cells have more corners than it has half-edges");
            f(block.cell(section.local_cell(i)), loops);
        }
    };
    for (const StandardSection& section : block.standard) for_section(section);
    block.with(for_section);
}

// Sets the loops of one cell. Leaves them empty if the block does not have the cell.
inline void read_loops(const Block& block, Index local_cell, CellLoops& loops) {
    const auto find_in = [&](const auto& section) {
        const auto cells = section.cell;
        const Index i = cells.empty() ? local_cell
                                      : static_cast<Index>(std::ranges::lower_bound(cells, local_cell) - cells.begin());
        if (i < section.count() && section.local_cell(i) == local_cell) read_loops(block, section, i, loops);
    };
    loops.clear();
    for (const StandardSection& section : block.standard) find_in(section);
    block.with(find_in);
}

} // namespace ciel
