#include "mesh/cell_faces.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

void list_own(const Ids owners, Index cells, CellFaces& out) {
    out.own_begin.reserve(std::size_t{cells} + 1);
    for (Index face = 0; face < owners.size(); ++face) {
        const std::size_t owner = owners[face];
        if (owner + 1 < out.own_begin.size()) owners.refuse();
        if (owner >= out.own_begin.size()) out.own_begin.resize(owner + 1, face);
    }
    out.own_begin.resize(std::size_t{cells} + 1, static_cast<Index>(owners.size()));
}

// Each neighbor is read twice. The second reading is checked, because a mapped file may change between the readings.
void list_others(const OptionalIds neighbours, Index cells, CellFaces& out) {
    out.other_begin.assign(std::size_t{cells} + 1, 0);
    for (const Index neighbour : neighbours)
        if (neighbour != none) ++out.other_begin[std::size_t{neighbour} + 1];
    for (std::size_t c = 1; c < out.other_begin.size(); ++c) out.other_begin[c] += out.other_begin[c - 1];
    out.other.resize(out.other_begin.back());
    std::vector<Index> cursor(out.other_begin.begin(), out.other_begin.end() - 1);
    for (Index face = 0; face < neighbours.size(); ++face) {
        const Index neighbour = neighbours[face];
        if (neighbour == none) continue;
        if (cursor[neighbour] == out.other_begin[std::size_t{neighbour} + 1] || face >= out.own_begin[neighbour])
            neighbours.refuse();
        out.other[cursor[neighbour]++] = face;
    }
}

} // namespace

CellFaces cell_faces(const FaceMeshView& mesh) {
    CellFaces out;
    list_own(mesh.owner, mesh.cell_count(), out);
    list_others(mesh.neighbour, mesh.cell_count(), out);
    return out;
}

void check_face_mesh(const FaceMeshView& mesh) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) fail(std::string("the mesh is damaged: ") + what + "; import it again");
    };
    require(mesh.positions.size() % 3 == 0, "positions do not hold three numbers per vertex");
    require(mesh.neighbour.size() == mesh.owner.size(), "owner and neighbour do not have the same length");
    require(mesh.face_offset.size() == mesh.owner.size() + 1, "face_offset does not hold one number more than owner");
    const auto offsets = mesh.face_offset.unchecked();
    require(offsets.front() == 0 && offsets.back() == mesh.face_vertex.size() && std::ranges::is_sorted(offsets),
            "face_offset does not rise from 0 to the length of face_vertex");
    const Index vertices = mesh.vertex_count(), cells = mesh.cell_count();
    require(std::ranges::all_of(mesh.face_vertex.unchecked(), [=](Index v) { return v < vertices; }),
            "a vertex id is out of range");
    const auto owners = mesh.owner.unchecked(), neighbours = mesh.neighbour.unchecked();
    require(std::ranges::is_sorted(owners) && (owners.empty() || owners.back() < cells),
            "owner is not sorted, or has a cell that does not exist");
    for (Index f = 0; f < mesh.face_count(); ++f)
        require(neighbours[f] == none || (neighbours[f] > owners[f] && neighbours[f] < cells),
                "a neighbour is not greater than its owner, or is a cell that does not exist");
}

} // namespace ciel::detail
