// Reads the faces of a block's cells as loops of vertices, without the paper's operators (section 2.2).
#pragma once

#include "blocks/block.hpp"

#include <utility>

namespace ciel::detail {

// The faces of one or more cells as loops. Each loop is wound outwards from its cell and has mesh-wide vertex ids.
struct CellLoops {
    std::vector<Index> begin{0}; // index in `vertex` of each face's first vertex, then the size of `vertex`
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

inline void add_face(const Block& block, const StandardSection& section, Index i, std::size_t face, CellLoops& loops) {
    const StandardShape& shape = *section.shape;
    for (std::size_t h = shape.face_begin[face]; h < shape.face_begin[face + 1]; ++h)
        loops.vertex.push_back(block.vertex(read_once(section.vertex[i * shape.corners + shape.origin[h]])));
    loops.end_face();
}

// Returns the corners of a face. Throws Error if the face or its corners do not exist, because the record has changed.
template <class Local, template <class> class Array>
[[nodiscard]] auto corners_of_face(const PolyhedralSection<Local, Array>& section, Index face) {
    if (face >= section.face_count()) refuse_changed("a cell has a face that does not exist");
    const auto loop = section.loop(face);
    if (loop.end > section.vertex.size()) refuse_changed("the corners of a face do not exist");
    return loop;
}

template <class Local, template <class> class Array>
void add_face(const Block& block, const PolyhedralSection<Local, Array>& section,
              const typename PolyhedralSection<Local, Array>::Loop& loop, Index side, CellLoops& loops) {
    const auto begin = static_cast<std::ptrdiff_t>(loops.vertex.size());
    for (Index corner = loop.begin; corner < loop.end; ++corner)
        loops.vertex.push_back(block.vertex(read_once(section.vertex[corner])));
    if (side == 1) std::reverse(loops.vertex.begin() + begin, loops.vertex.end());
    loops.end_face();
}

inline void read_loops(const Block& block, const StandardSection& section, Index i, CellLoops& loops) {
    loops.clear();
    for (std::size_t face = 0; face < section.shape->faces; ++face) add_face(block, section, i, face, loops);
}

template <class Local, template <class> class Array>
void read_loops(const Block& block, const PolyhedralSection<Local, Array>& section, Index i, CellLoops& loops) {
    loops.clear();
    for (const Local& entry : section.faces_of(i)) {
        const Index face_and_side = read_once(entry);
        const auto loop = corners_of_face(section, face_and_side / 2);
        if (loops.vertex.size() + loop.size() > section.half_edge_count())
            refuse_changed("a cell has more corners than its block");
        add_face(block, section, loop, face_and_side % 2, loops);
    }
}

// Calls f(mesh-wide cell id, loops) for each cell, section by section. `loops` is overwritten for the next cell. Throws
// Error if a changed record has too many corners.
template <class F>
void for_cells(const Block& block, CellLoops& loops, F&& f) {
    std::size_t corners = 0;
    const auto for_section = [&](const auto& section) {
        for (Index i = 0; i < section.count(); ++i) {
            read_loops(block, section, i, loops);
            corners += loops.vertex.size();
            if (corners > block.half_edge_count)
                refuse_changed("the cells of the block have more corners than the block has half-edges");
            f(block.cell(section.local_cell(i)), loops);
        }
    };
    for (const StandardSection& section : block.standard) for_section(section);
    block.with(for_section);
}

// Calls f(mesh-wide cell id, mesh-wide vertex id) once for each vertex of each cell. `seen`: scratch. Throws Error if a
// changed record has too many corners.
template <class F>
void for_corners_of_cells(const Block& block, std::vector<Index>& seen, F&& f) {
    seen.assign(block.vertex_count, none); // by local vertex: the last cell of the section that has it
    std::size_t corners = 0;
    const auto see = [&](Index local, Index i, Index cell) {
        if (local >= seen.size()) refuse_changed("a cell has a vertex that does not exist");
        if (std::exchange(seen[local], i) != i) f(cell, block.vertex(local));
    };
    for (const StandardSection& section : block.standard) {
        for (Index i = 0; i < section.count(); ++i)
            for (std::size_t c = 0; c < section.shape->corners; ++c)
                see(read_once(section.vertex[i * section.shape->corners + c]), i, block.cell(section.local_cell(i)));
        seen.assign(block.vertex_count, none);
    }
    block.with([&](const auto& section) {
        for (Index i = 0; i < section.count(); ++i)
            for (const auto& entry : section.faces_of(i)) {
                const auto loop = corners_of_face(section, read_once(entry) / 2);
                corners += loop.size();
                if (corners > section.half_edge_count()) refuse_changed("a cell has more corners than its block");
                for (Index corner = loop.begin; corner < loop.end; ++corner)
                    see(read_once(section.vertex[corner]), i, block.cell(section.local_cell(i)));
            }
    });
}

// Calls f(section, index of the cell in the section), unless the block does not have the cell.
template <class F>
void with_cell(const Block& block, Index local_cell, F&& f) {
    const auto find_in = [&](const auto& section) {
        const auto cells = section.cell;
        const Index i = cells.empty() ? local_cell
                                      : static_cast<Index>(std::ranges::lower_bound(cells, local_cell) - cells.begin());
        if (i < section.count() && section.local_cell(i) == local_cell) f(section, i);
    };
    for (const StandardSection& section : block.standard) find_in(section);
    block.with(find_in);
}

// Reads the faces of one cell. Leaves `loops` empty if the block does not have the cell.
inline void read_loops(const Block& block, Index local_cell, CellLoops& loops) {
    loops.clear();
    with_cell(block, local_cell, [&](const auto& section, Index i) { read_loops(block, section, i, loops); });
}

template <class F>
void for_corners(const Block& block, const StandardSection& section, Index i, F&& f) {
    for (std::size_t c = 0; c < section.shape->corners; ++c)
        f(block.vertex(read_once(section.vertex[i * section.shape->corners + c])));
}

template <class Local, template <class> class Array, class F>
void for_corners(const Block& block, const PolyhedralSection<Local, Array>& section, Index i, F&& f) {
    std::size_t corners = 0;
    for (const Local& entry : section.faces_of(i)) {
        const auto loop = corners_of_face(section, Index{read_once(entry)} / 2);
        corners += loop.size();
        if (corners > section.half_edge_count()) refuse_changed("a cell has more corners than its block");
        for (Index corner = loop.begin; corner < loop.end; ++corner) f(block.vertex(read_once(section.vertex[corner])));
    }
}

// Calls f(mesh-wide vertex id) for each vertex of one cell; for a vertex of a polyhedron, once for each face that has
// it. Calls nothing if the block does not have the cell. Throws Error if a changed record has too many corners.
template <class F>
void for_corners_of_cell(const Block& block, Index local_cell, F&& f) {
    with_cell(block, local_cell, [&](const auto& section, Index i) { for_corners(block, section, i, f); });
}

} // namespace ciel::detail
