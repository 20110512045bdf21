#include "mesh/cell_faces.hpp"

#include <algorithm>

namespace ciel::detail {

CellFaces cell_faces(const FaceMeshView& mesh) {
    CellFaces out;
    out.begin.assign(std::size_t{mesh.cell_count()} + 1, 0);
    // Captures copies of both arrays, so that their index limits stay in registers while `out` is written.
    const auto for_cells_of = [owner = mesh.owner, neighbours = mesh.neighbour](Index f, auto&& visit) {
        visit(owner[f]);
        if (const Index neighbour = neighbours[f]; neighbour != none) visit(neighbour);
    };
    for (Index f = 0; f < mesh.face_count(); ++f)
        for_cells_of(f, [&](Index cell) { ++out.begin[std::size_t{cell} + 1]; });
    for (std::size_t c = 1; c < out.begin.size(); ++c) out.begin[c] += out.begin[c - 1];
    out.face.resize(out.begin.back());
    std::vector<std::uint64_t> cursor(out.begin.begin(), out.begin.end() - 1);
    for (Index f = 0; f < mesh.face_count(); ++f)
        for_cells_of(f, [&](Index cell) {
            if (cursor[cell] == out.begin[std::size_t{cell} + 1]) mesh.owner.refuse(); // the mapped file changed
            out.face[cursor[cell]++] = f;
        });
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
