#include "ciel/block_loops.hpp"

#include "ciel/loop.hpp"

#include <algorithm>

namespace ciel {

BlockLoops::BlockLoops(const FaceMeshView& whole, const CellFaces& faces)
    : mesh(whole), faces_(faces), local_vertex_(whole.vertex_count(), none) {}

void BlockLoops::gather(Index from, Index to) {
    cell_begin = from;
    cell_end = to;
    list_faces();
    number_vertices();
    find_edges();
}

void BlockLoops::forget() {
    for (const Index v : vertices) local_vertex_[v] = none;
}

void BlockLoops::list_faces() {
    const auto first_owned = [&](Index cell) {
        return static_cast<Index>(std::ranges::lower_bound(mesh.owner, cell) - mesh.owner.begin());
    };
    const Index face_begin = first_owned(cell_begin), face_end = first_owned(cell_end);
    mesh_face.clear();
    begin.assign(1, 0);
    vertex.clear();
    vertices.clear();
    const auto append = [&](Index face) {
        const std::span<const Index> loop = mesh.loop(face);
        const bool any = append_without_repeats(loop, vertex) > 0;
        if (!any && !loop.empty()) note_vertex(loop.front());
        mesh_face.push_back(face);
        begin.push_back(static_cast<Index>(vertex.size()));
        return any;
    };
    for (Index face = face_begin; face < face_end; ++face) append(face);
    cell_loop_begin.assign(1, 0);
    cell_loop.clear();
    for (Index cell = cell_begin; cell < cell_end; ++cell) {
        for (const Index face : faces_.of(cell)) {
            const Index side = mesh.owner[face] == cell ? 0 : 1;
            const Index loop = face >= face_begin ? face - face_begin : loop_count();
            const bool any = face >= face_begin ? begin[loop] != begin[loop + 1] : append(face);
            if (any) cell_loop.push_back(2 * loop + side);
        }
        cell_loop_begin.push_back(static_cast<Index>(cell_loop.size()));
    }
}

void BlockLoops::note_vertex(Index v) {
    if (local_vertex_[v] != none) return;
    local_vertex_[v] = 0;
    vertices.push_back(v);
}

void BlockLoops::number_vertices() {
    for (const Index v : vertex) note_vertex(v);
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
