#include "blocks/block_loops.hpp"

#include "mesh/loop.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ciel::detail {

BlockLoops::BlockLoops(const FaceMeshView& whole, const CellFaces& faces) : mesh(whole), faces_(faces) {}

void BlockLoops::gather(Index from, Index to) {
    cell_begin = from;
    cell_end = to;
    list_faces();
    check_sides();
    number_vertices();
    find_edges();
}

// The faces that cells of the block own are consecutive in the mesh.
void BlockLoops::copy_own(Index face_begin, Index face_end) {
    const auto offsets = mesh.face_offset.unchecked().subspan(face_begin, std::size_t{face_end} - face_begin + 1);
    own_offset_.assign(offsets.begin(), offsets.end());
    const std::uint64_t first = own_offset_.front(), last = own_offset_.back();
    if (!std::ranges::is_sorted(own_offset_) || last > mesh.face_vertex.size() || last - first >= none)
        mesh.face_offset.refuse();
    const auto ids = mesh.face_vertex.unchecked().subspan(first, last - first);
    vertex.assign(ids.begin(), ids.end());
    begin.resize(own_offset_.size());
    std::ranges::transform(own_offset_, begin.begin(),
                           [=](std::uint64_t at) { return static_cast<Index>(at - first); });
    mesh_face.resize(face_end - face_begin);
    std::iota(mesh_face.begin(), mesh_face.end(), face_begin);
    mesh_cell.resize(mesh_face.size());
    for (Index i = 0; i < mesh_cell.size(); ++i)
        mesh_cell[i] = {mesh.owner[face_begin + i], mesh.neighbour[face_begin + i]};
    if (has_repeats()) remove_repeats();
}

bool BlockLoops::has_repeats() const {
    for (Index loop = 0; loop < loop_count(); ++loop) {
        const Index end = begin[loop + 1];
        if (begin[loop] == end) continue;
        Index last = vertex[end - 1];
        for (Index k = begin[loop]; k < end; ++k) {
            if (vertex[k] == last) return true;
            last = vertex[k];
        }
    }
    return false;
}

void BlockLoops::remove_repeats() {
    const std::vector<Index> whole = std::exchange(vertex, {}), whole_begin = std::exchange(begin, {0});
    for (std::size_t loop = 0; loop + 1 < whole_begin.size(); ++loop)
        append_loop(std::span(whole).subspan(whole_begin[loop], whole_begin[loop + 1] - whole_begin[loop]));
}

// Returns false when the loop has collapsed to a point, so that no corner was appended.
bool BlockLoops::append_loop(std::span<const Index> ids) {
    const bool any = append_without_repeats(ids, vertex) > 0;
    if (!any && !ids.empty()) collapsed_.push_back(ids.front());
    begin.push_back(static_cast<Index>(vertex.size()));
    return any;
}

bool BlockLoops::append(Index face) {
    const auto ids = mesh.loop(face).unchecked();
    if (ids.size() >= none - vertex.size()) mesh.face_offset.refuse(); // the corners of a block must fit 32 bits
    loop_.assign(ids.begin(), ids.end());
    mesh_face.push_back(face);
    mesh_cell.push_back({mesh.owner[face], mesh.neighbour[face]});
    return append_loop(loop_);
}

void BlockLoops::list_faces() {
    const Index face_begin = faces_.own_begin[cell_begin], face_end = faces_.own_begin[cell_end];
    collapsed_.clear();
    copy_own(face_begin, face_end);
    cell_loop_begin.assign(1, 0);
    cell_loop.clear();
    for (Index cell = cell_begin; cell < cell_end; ++cell) {
        for (const Index face : faces_.others(cell)) {
            const bool is_listed = face >= face_begin;
            const Index loop = is_listed ? face - face_begin : loop_count();
            const bool any = is_listed ? begin[loop] != begin[loop + 1] : append(face);
            if (mesh_cell[loop][1] != cell) mesh.neighbour.refuse();
            if (any) cell_loop.push_back(2 * loop + 1);
        }
        for (Index loop = faces_.own_begin[cell] - face_begin; loop < faces_.own_begin[cell + 1] - face_begin; ++loop) {
            if (mesh_cell[loop][0] != cell) mesh.owner.refuse();
            if (begin[loop] != begin[loop + 1]) cell_loop.push_back(2 * loop);
        }
        cell_loop_begin.push_back(static_cast<Index>(cell_loop.size()));
    }
}

// Throws Error when a loop has a cell of this block on one side, but the list of this cell does not have the loop.
void BlockLoops::check_sides() const {
    std::size_t sides = 0;
    for (Index loop = 0; loop < loop_count(); ++loop)
        if (begin[loop] != begin[loop + 1])
            sides += (cell_on(loop, 0) != none ? 1 : 0) + (cell_on(loop, 1) != none ? 1 : 0);
    if (sides != cell_loop.size()) mesh.owner.refuse();
}

void BlockLoops::number_vertices() {
    Index highest = 0;
    for (const auto* ids : {&vertex, &collapsed_})
        for (const Index v : *ids) highest = std::max(highest, v);
    if (highest >= mesh.vertex_count()) mesh.face_vertex.refuse();
    local_vertex_.begin(highest, vertex.size() + collapsed_.size());
    for (const auto* ids : {&vertex, &collapsed_})
        for (const Index v : *ids) local_vertex_.add(v);
    local_vertex_.number(vertices);
    for (Index& v : vertex) v = local_vertex_[v];
}

// Numbers the edges by first appearance, so that their mesh-wide order does not depend on the block size.
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

} // namespace ciel::detail
