#include "ciel/block_builder.hpp"

#include "ciel/loop.hpp"

#include <algorithm>

namespace ciel {

BlockBuilder::BlockBuilder(const FaceMeshView& mesh, const CellFaces& faces)
    : mesh_(mesh), faces_(faces), local_vertex_(mesh.vertex_count(), none) {}

BuiltBlock BlockBuilder::build(Index cell_begin, Index cell_end) {
    cell_begin_ = cell_begin;
    cell_end_ = cell_end;
    BuiltBlock built;
    built.block.cell_begin = cell_begin;
    built.block.cell_count = cell_end - cell_begin;
    list_faces(built);
    gather_loops(built);
    collect_vertices(built.block);
    if (corner_vertex_.size() + built.block.inner_corners < BlockArrays<std::uint16_t>::end_of_list)
        fill<std::uint16_t>(built);
    else
        fill<std::uint32_t>(built);
    for (const Index v : built.block.vertex) local_vertex_[v] = none;
    return built;
}

void BlockBuilder::list_faces(BuiltBlock& built) {
    const auto first_owned = [&](Index cell) {
        return static_cast<Index>(std::ranges::lower_bound(mesh_.owner, cell) - mesh_.owner.begin());
    };
    face_begin_ = first_owned(cell_begin_);
    face_end_ = first_owned(cell_end_);
    inner_.clear();
    near_tail_.clear();
    far_tail_.clear();
    for (Index f = face_begin_; f < face_end_; ++f) (mesh_.neighbour[f] < cell_end_ ? inner_ : near_tail_).push_back(f);
    for (Index cell = cell_begin_; cell < cell_end_; ++cell)
        for (const Index f : faces_.of(cell))
            if (f < face_begin_) far_tail_.push_back(f);
    built.tail_face.clear();
}

// Faces that collapsed to a point have no half-edge and no place in the block.
void BlockBuilder::gather_loops(BuiltBlock& built) {
    Block& block = built.block;
    corner_vertex_.clear();
    local_face_.assign(face_end_ - face_begin_, none);
    block.face_begin.assign(1, 0);
    const auto append = [&](Index f) {
        if (append_without_repeats(mesh_.loop(f), corner_vertex_) == 0) return false;
        if (f >= face_begin_) local_face_[f - face_begin_] = static_cast<Index>(block.face_begin.size() - 1);
        block.face_begin.push_back(static_cast<Index>(corner_vertex_.size()));
        return true;
    };
    for (const Index f : inner_) append(f);
    block.inner_faces = static_cast<Index>(block.face_begin.size() - 1);
    block.inner_corners = static_cast<Index>(corner_vertex_.size());
    for (const Index f : near_tail_)
        if (append(f)) built.tail_face.push_back(f);
    block.far_corner = static_cast<Index>(corner_vertex_.size());
    for (const Index f : far_tail_)
        if (append(f)) built.tail_face.push_back(f);
}

void BlockBuilder::collect_vertices(Block& block) {
    for (const Index v : corner_vertex_) {
        if (local_vertex_[v] != none) continue;
        local_vertex_[v] = 0;
        block.vertex.push_back(v);
    }
    std::ranges::sort(block.vertex);
    for (Index local = 0; local < block.vertex.size(); ++local) local_vertex_[block.vertex[local]] = local;
}

template <class Local>
void BlockBuilder::fill(BuiltBlock& built) {
    BlockArrays<Local> arrays;
    fill_corners(built.block, arrays);
    find_edges(built.block, arrays);
    list_cell_faces(built.block, arrays);
    pair_half_edges(built.block, arrays);
    built.block.arrays = std::move(arrays);
}

template <class Local>
void BlockBuilder::fill_corners(const Block& block, BlockArrays<Local>& arrays) {
    const std::size_t corners = corner_vertex_.size();
    arrays.vertex.resize(corners);
    arrays.face.resize(corners);
    for (Index f = 0; f + 1 < block.face_begin.size(); ++f)
        for (Index k = block.face_begin[f]; k < block.face_begin[f + 1]; ++k) {
            arrays.vertex[k] = static_cast<Local>(local_vertex_[corner_vertex_[k]]);
            arrays.face[k] = static_cast<Local>(f);
        }
    arrays.next_corner.resize(corners);
    arrays.first_corner.assign(block.vertex.size(), arrays.end_of_list);
    for (std::size_t k = corners; k-- > 0;) {
        arrays.next_corner[k] = arrays.first_corner[arrays.vertex[k]];
        arrays.first_corner[arrays.vertex[k]] = static_cast<Local>(k);
    }
}

// Edges in order of first appearance in the mesh's faces: for the edges that the block owns, that is the mesh-wide
// order, whatever the size of the blocks.
template <class Local>
void BlockBuilder::find_edges(const Block& block, BlockArrays<Local>& arrays) {
    arrays.edge.resize(corner_vertex_.size());
    edge_head_.assign(block.vertex.size(), none);
    edge_next_.clear();
    const auto visit = [&](Index face) {
        for (Index k = block.face_begin[face]; k < block.face_begin[face + 1]; ++k) {
            const Local a = arrays.vertex[k], b = arrays.vertex[block.next_in_loop(k, face)];
            const Local low = std::min(a, b), high = std::max(a, b);
            Index e = edge_head_[low];
            while (e != none && arrays.edge_high[e] != high) e = edge_next_[e];
            if (e == none) {
                e = static_cast<Index>(edge_next_.size());
                arrays.edge_low.push_back(low);
                arrays.edge_high.push_back(high);
                edge_next_.push_back(edge_head_[low]);
                edge_head_[low] = e;
            }
            arrays.edge[k] = static_cast<Local>(e);
        }
    };
    for (const Index face : local_face_)
        if (face != none) visit(face);
    for (Index face = arrays.face.size() > block.far_corner ? arrays.face[block.far_corner] : none;
         face < block.face_begin.size() - 1; ++face)
        visit(face);
}

template <class Local>
void BlockBuilder::list_cell_faces(Block& block, BlockArrays<Local>& arrays) {
    const std::size_t faces = block.face_begin.size() - 1;
    arrays.face_cell.resize(faces);
    block.cell_face_begin.assign(1, 0);
    Index next_far = arrays.face.size() > block.far_corner ? arrays.face[block.far_corner] : none;
    std::vector<Index> loop;
    for (Index cell = cell_begin_; cell < cell_end_; ++cell) {
        for (const Index f : faces_.of(cell)) {
            const Index side = mesh_.owner[f] == cell ? 0 : 1;
            Index local;
            if (f >= face_begin_) {
                local = local_face_[f - face_begin_];
                if (local == none) continue;
            } else {
                loop.clear();
                if (append_without_repeats(mesh_.loop(f), loop) == 0) continue;
                local = next_far++; // far tails were listed in this same order
            }
            arrays.cell_face.push_back(static_cast<Local>(2 * local + side));
            const auto local_cell = static_cast<Local>(cell - cell_begin_);
            if (local < block.inner_faces)
                arrays.face_cell[local][side] = local_cell;
            else
                arrays.face_cell[local] = {local_cell, local_cell};
        }
        block.cell_face_begin.push_back(static_cast<Index>(arrays.cell_face.size()));
    }
    arrays.cell_face.shrink_to_fit();
}

// Inside a cell the two half-edges of an edge are mates. Where a cell touches itself along an edge there are more: any
// pairing of opposite directions is sound, one between different faces is preferred.
template <class Local>
void BlockBuilder::pair_half_edges(const Block& block, BlockArrays<Local>& arrays) {
    arrays.mate_face.resize(corner_vertex_.size() + block.inner_corners);
    open_.assign(arrays.edge_low.size(), none);
    open_next_.assign(arrays.mate_face.size(), none);
    for (Index cell = 0; cell < block.cell_count; ++cell) {
        waiting_.clear();
        for (Index i = block.cell_face_begin[cell]; i < block.cell_face_begin[cell + 1]; ++i) {
            const Index face = arrays.cell_face[i] / 2, side = arrays.cell_face[i] % 2;
            for (Index k = block.face_begin[face]; k < block.face_begin[face + 1]; ++k)
                pair_half_edge(block, arrays, block.half_edge(k, side));
        }
        pair_inside_faces(block, arrays, cell);
    }
}

namespace {

template <class Local>
bool runs_upward(const Block& block, const BlockArrays<Local>& arrays, Index h) {
    const Index corner = block.corner(h);
    return (arrays.vertex[corner] == arrays.edge_low[arrays.edge[corner]]) == (block.side(h) == 0);
}

} // namespace

template <class Local>
void BlockBuilder::pair_half_edge(const Block& block, BlockArrays<Local>& arrays, Index h) {
    const Index corner = block.corner(h), edge = arrays.edge[corner];
    const bool upward = runs_upward(block, arrays, h);
    Index* link = &open_[edge];
    if (*link == none) waiting_.push_back(edge);
    while (*link != none &&
           (runs_upward(block, arrays, *link) == upward || arrays.face[block.corner(*link)] == arrays.face[corner]))
        link = &open_next_[*link];
    if (*link == none) {
        open_next_[h] = open_[edge];
        open_[edge] = h;
        return;
    }
    const Index mate = *link;
    *link = open_next_[mate];
    arrays.mate_face[h] = static_cast<Local>(mate);
    arrays.mate_face[mate] = static_cast<Local>(h);
}

// A face that collapsed to a line may have to be its own neighbour.
template <class Local>
void BlockBuilder::pair_inside_faces(const Block& block, BlockArrays<Local>& arrays, Index cell) {
    for (const Index edge : waiting_) {
        while (open_[edge] != none) {
            const Index h = open_[edge];
            Index* link = &open_next_[h];
            while (*link != none && runs_upward(block, arrays, *link) == runs_upward(block, arrays, h))
                link = &open_next_[*link];
            if (*link == none)
                fail("the mesh is damaged: cell " + std::to_string(block.cell_begin + cell) +
                     " is not closed; import it again");
            const Index mate = *link;
            *link = open_next_[mate];
            open_[edge] = open_next_[h];
            arrays.mate_face[h] = static_cast<Local>(mate);
            arrays.mate_face[mate] = static_cast<Local>(h);
        }
    }
}

} // namespace ciel
