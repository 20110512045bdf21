#include "ciel/block_loops.hpp"

#include "ciel/loop.hpp"

#include <algorithm>
#include <functional>

namespace ciel {

BlockLoops::BlockLoops(const FaceMeshView& whole, const CellFaces& faces) : mesh(whole), faces_(faces) {}

void BlockLoops::gather(Index from, Index to) {
    cell_begin = from;
    cell_end = to;
    list_faces();
    check_sides();
    number_vertices();
    find_edges();
}

// Returns false when the loop collapsed to a point.
bool BlockLoops::append(Index face) {
    const Ids loop = mesh.loop(face);
    if (loop.size() >= none - vertex.size()) mesh.face_offset.refuse(); // loops of one mesh do not overlap
    const bool any = append_without_repeats(loop, vertex) > 0;
    if (!any && !loop.empty()) collapsed_.push_back(loop.front());
    mesh_face.push_back(face);
    mesh_cell.push_back({mesh.owner[face], mesh.neighbour[face]});
    begin.push_back(static_cast<Index>(vertex.size()));
    return any;
}

void BlockLoops::list_faces() {
    const auto first_owned = [&](Index cell) {
        return static_cast<Index>(std::ranges::lower_bound(mesh.owner, cell) - mesh.owner.begin());
    };
    const Index face_begin = first_owned(cell_begin), face_end = std::max(face_begin, first_owned(cell_end));
    mesh_face.clear();
    mesh_cell.clear();
    begin.assign(1, 0);
    vertex.clear();
    collapsed_.clear();
    for (Index face = face_begin; face < face_end; ++face) append(face);
    cell_loop_begin.assign(1, 0);
    cell_loop.clear();
    for (Index cell = cell_begin; cell < cell_end; ++cell) {
        for (const Index face : faces_.of(cell)) {
            const bool is_listed = face >= face_begin && face < face_end;
            const Index loop = is_listed ? face - face_begin : loop_count();
            const bool any = is_listed ? begin[loop] != begin[loop + 1] : append(face);
            const Index side = mesh_cell[loop][0] == cell ? 0 : 1;
            if (mesh_cell[loop][side] != cell) mesh.owner.refuse();
            if (any) cell_loop.push_back(2 * loop + side);
        }
        cell_loop_begin.push_back(static_cast<Index>(cell_loop.size()));
    }
}

// Each side of a loop that is a cell of this block is in that cell's list, once.
void BlockLoops::check_sides() const {
    std::size_t sides = 0;
    for (Index loop = 0; loop < loop_count(); ++loop)
        if (begin[loop] != begin[loop + 1])
            sides += (cell_on(loop, 0) != none ? 1 : 0) + (cell_on(loop, 1) != none ? 1 : 0);
    bool rises = sides == cell_loop.size();
    for (Index cell = 0; cell < cell_end - cell_begin; ++cell) {
        const auto faces = faces_.of(cell_begin + cell);
        rises = rises && std::ranges::adjacent_find(faces, std::ranges::greater_equal()) == faces.end();
    }
    if (!rises) mesh.owner.refuse();
}

void BlockLoops::number_vertices() {
    Index highest = 0;
    for (const auto* ids : {&vertex, &collapsed_})
        for (const Index v : *ids) highest = std::max(highest, v);
    local_vertex_.begin(highest, vertex.size() + collapsed_.size());
    vertices.clear();
    const auto note = [&](Index v) {
        if (local_vertex_.add(v)) vertices.push_back(v);
    };
    for (const Index v : collapsed_) note(v);
    for (const Index v : vertex) note(v);
    std::ranges::sort(vertices);
    for (Index local = 0; local < vertices.size(); ++local) local_vertex_[vertices[local]] = local;
    for (Index& v : vertex) v = local_vertex_[v];
}

// By first appearance: for the edges that the block owns, that is the mesh-wide order, whatever the size of the blocks.
void BlockLoops::find_edges() {
    edge.resize(vertex.size());
    edge_ends.clear();
    edge_head_.assign(vertices.size(), none);
    edge_next_.clear();
    crowded_edge_.clear();
    for (Index loop = 0; loop < loop_count(); ++loop)
        for (Index k = begin[loop]; k < begin[loop + 1]; ++k) {
            const Index a = vertex[k], b = vertex[k + 1 == begin[loop + 1] ? begin[loop] : k + 1];
            edge[k] = edge_between(std::min(a, b), std::max(a, b));
        }
}

Index BlockLoops::edge_between(Index low, Index high) {
    constexpr Index most_listed = 64;
    Index listed = 0;
    for (Index e = edge_head_[low]; e != none; e = edge_next_[e], ++listed)
        if (edge_ends[e][1] == high) return e;
    const auto created = static_cast<Index>(edge_ends.size());
    if (listed == most_listed) {
        const auto [known, is_new] = crowded_edge_.try_emplace(std::uint64_t{low} << 32 | high, created);
        if (!is_new) return known->second;
    }
    edge_ends.push_back({low, high});
    edge_next_.push_back(listed < most_listed ? edge_head_[low] : none);
    if (listed < most_listed) edge_head_[low] = created;
    return created;
}

} // namespace ciel
