#include "mesh/polyhedra_lists.hpp"

#include "ciel/face_lists.hpp"
#include "ciel/vtk_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ciel::detail {
namespace {

Index id_of(const ArrayView& ids, std::size_t i) {
    const std::int64_t id = ids.integer(i);
    return id < 0 || id >= std::int64_t{none} ? none : static_cast<Index>(id);
}

void check_ids(const ArrayView& ids, const char* name) {
    if (ids.columns() != 1) fail(std::string(name) + " must have one number per row");
    if (!ids.empty() && !ids.has_integers()) fail(std::string(name) + " must hold integers");
}

std::size_t offset(const ArrayView& offsets, std::size_t i, std::size_t end, const char* name) {
    const std::int64_t at = offsets.integer(i);
    if (at < 0 || static_cast<std::uint64_t>(at) > end || (i > 0 && at < offsets.integer(i - 1)))
        fail(std::string(name) + " must rise from 0 to " + std::to_string(end) +
             ", the length of the array that it indexes; entry " + std::to_string(i) + " is " + std::to_string(at));
    return static_cast<std::size_t>(at);
}

void close_face(PolyhedraLists& lists) { lists.face_offset.push_back(lists.face_vertex.size()); }

void close_cell(PolyhedraLists& lists, std::size_t source) {
    lists.cell_offset.push_back(lists.face_offset.size() - 1);
    lists.source_cell.push_back(static_cast<Index>(source));
    const std::size_t faces = lists.cell_offset.back() - lists.cell_offset[lists.cell_offset.size() - 2];
    lists.cell_types.push_back(
        static_cast<std::uint8_t>(type_of_cell(std::span(lists.face_offset).last(faces + 1), lists.face_vertex)));
}

// VTK's types without volume, and convex point sets (41), for which VTK lists no faces.
constexpr std::array<int, 27> without_volume{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  21, 22, 23, 28,
                                             30, 34, 35, 36, 41, 68, 69, 70, 75, 76, 77, 60, 61};

void add_shape(const VtkShape& shape, const VtkCells& cells, std::size_t cell, PolyhedraLists& lists) {
    const std::size_t size = cells.connectivity.rows();
    const std::size_t begin = offset(cells.offsets, cell, size, "offsets");
    const std::size_t count = offset(cells.offsets, cell + 1, size, "offsets") - begin;
    if (count < shape.corners)
        fail("cell " + std::to_string(cell) + " has " + std::to_string(count) + " points; its type needs " +
             std::to_string(shape.corners));
    VtkCorners corners{};
    for (std::size_t i = 0; i < shape.corners; ++i) corners[i] = id_of(cells.connectivity, begin + i);
    lists.reduced += shape.reduced_from != nullptr ? 1 : 0;
    append_vtk_faces(shape, corners, lists.face_offset, lists.face_vertex);
    close_cell(lists, cell);
}

// Appends a polyhedron from the face stream of VTK up to 9.3 (VtkCells::faces).
void add_face_stream(const VtkCells& cells, std::size_t cell, PolyhedraLists& lists) {
    auto next = [&, at = cells.face_locations.integer(cell)]() mutable {
        if (at < 0 || static_cast<std::uint64_t>(at) >= cells.faces.rows())
            fail("the faces of polyhedron " + std::to_string(cell) + " lie outside the array of faces");
        return cells.faces.integer(static_cast<std::size_t>(at++));
    };
    const std::int64_t faces = next();
    for (std::int64_t face = 0; face < faces; ++face) {
        const std::int64_t corners = next();
        for (std::int64_t i = 0; i < corners; ++i) {
            const std::int64_t id = next();
            lists.face_vertex.push_back(id < 0 || id >= std::int64_t{none} ? none : static_cast<Index>(id));
        }
        close_face(lists);
    }
    close_cell(lists, cell);
}

// Appends a polyhedron from the face lists of VTK from 9.4 on (VtkCells::cell_faces).
void add_listed_faces(const VtkCells& cells, std::size_t cell, PolyhedraLists& lists) {
    const std::size_t listed = cells.cell_faces.rows(), size = cells.face_connectivity.rows();
    const std::size_t begin = offset(cells.cell_face_offsets, cell, listed, "cell_face_offsets");
    const std::size_t end = offset(cells.cell_face_offsets, cell + 1, listed, "cell_face_offsets");
    for (std::size_t i = begin; i < end; ++i) {
        const std::int64_t face = cells.cell_faces.integer(i);
        if (face < 0 || static_cast<std::uint64_t>(face) + 1 >= cells.face_offsets.rows())
            fail("polyhedron " + std::to_string(cell) + " has the face " + std::to_string(face) +
                 ", which does not exist");
        const auto f = static_cast<std::size_t>(face);
        const std::size_t last = offset(cells.face_offsets, f + 1, size, "face_offsets");
        for (std::size_t k = offset(cells.face_offsets, f, size, "face_offsets"); k < last; ++k)
            lists.face_vertex.push_back(id_of(cells.face_connectivity, k));
        close_face(lists);
    }
    close_cell(lists, cell);
}

void add_polyhedron(const VtkCells& cells, std::size_t cell, PolyhedraLists& lists) {
    if (!cells.cell_face_offsets.empty()) return add_listed_faces(cells, cell, lists);
    if (cells.face_locations.rows() <= cell)
        fail("cell " + std::to_string(cell) +
             " is a polyhedron, but its faces are not given; pass them in faces and face_locations");
    add_face_stream(cells, cell, lists);
}

} // namespace

std::uint64_t PolyhedraLists::bytes() const {
    return points.view().size_bytes() + cell_types.size() + (cell_offset.size() + face_offset.size()) * 8 +
           (face_vertex.size() + source_cell.size()) * sizeof(Index);
}

void put_points(const ArrayView& points, PolyhedraLists& lists) {
    if (points.columns() != 3) fail("points must have three numbers per row");
    if (points.rows() >= none) fail("the mesh has more than 4,294,967,294 points; split it");
    lists.points = mesh_points(points);
}

void put_polyhedra(const ArrayView& cell_offset, const ArrayView& face_offset, const ArrayView& face_vertex,
                   PolyhedraLists& lists) {
    check_ids(cell_offset, "cell_offset");
    check_ids(face_offset, "face_offset");
    check_ids(face_vertex, "face_vertex");
    if (cell_offset.empty() || face_offset.empty()) fail("cell_offset and face_offset must have one entry at least");
    const std::size_t faces = face_offset.rows() - 1;
    for (std::size_t cell = 0; cell + 1 < cell_offset.rows(); ++cell) {
        const std::size_t end = offset(cell_offset, cell + 1, faces, "cell_offset");
        for (std::size_t face = offset(cell_offset, cell, faces, "cell_offset"); face < end; ++face) {
            const std::size_t last = offset(face_offset, face + 1, face_vertex.rows(), "face_offset");
            for (std::size_t i = offset(face_offset, face, face_vertex.rows(), "face_offset"); i < last; ++i)
                lists.face_vertex.push_back(id_of(face_vertex, i));
            close_face(lists);
        }
        close_cell(lists, cell);
    }
}

void put_owner_faces(const ArrayView& face_offset, const ArrayView& face_vertex, const ArrayView& owner,
                     const ArrayView& neighbour, PolyhedraLists& lists) {
    check_ids(face_offset, "face_offset");
    check_ids(face_vertex, "face_vertex");
    check_ids(owner, "owner");
    check_ids(neighbour, "neighbour");
    if (face_offset.rows() != owner.rows() + 1) fail("face_offset must have one entry more than owner");
    if (neighbour.rows() > owner.rows()) fail("neighbour must not have more entries than owner");
    // Limits cell ids, because the greatest determines an allocation's size. Each cell has at least one side of a face.
    const auto sides_at_most = static_cast<std::int64_t>(2 * owner.rows());
    std::vector<std::uint64_t> begin(1);
    const auto sides = [&](auto&& visit) {
        for (std::size_t face = 0; face < owner.rows(); ++face) {
            const std::int64_t of = owner.integer(face);
            if (of < 0 || of >= sides_at_most)
                fail("owner of face " + std::to_string(face) + " is " + std::to_string(of) + ", which is not a cell");
            visit(static_cast<std::size_t>(of), face);
            const std::int64_t other = face < neighbour.rows() ? neighbour.integer(face) : -1;
            if (other >= sides_at_most)
                fail("neighbour of face " + std::to_string(face) + " is " + std::to_string(other) +
                     ", which is not a cell");
            if (other >= 0) visit(static_cast<std::size_t>(other), face);
        }
    };
    sides([&](std::size_t cell, std::size_t) {
        if (cell + 2 > begin.size()) begin.resize(cell + 2);
        ++begin[cell + 1];
    });
    for (std::size_t cell = 1; cell < begin.size(); ++cell) begin[cell] += begin[cell - 1];
    std::vector<std::uint64_t> at(begin.begin(), begin.end() - 1);
    std::vector<std::size_t> faces(begin.back());
    sides([&](std::size_t cell, std::size_t face) { faces[at[cell]++] = face; });
    for (std::size_t cell = 0; cell + 1 < begin.size(); ++cell) {
        for (std::uint64_t i = begin[cell]; i < begin[cell + 1]; ++i) {
            const std::size_t last = offset(face_offset, faces[i] + 1, face_vertex.rows(), "face_offset");
            for (std::size_t k = offset(face_offset, faces[i], face_vertex.rows(), "face_offset"); k < last; ++k)
                lists.face_vertex.push_back(id_of(face_vertex, k));
            close_face(lists);
        }
        close_cell(lists, cell);
    }
}

void put_vtk_cells(const VtkCells& cells, PolyhedraLists& lists) {
    check_ids(cells.types, "types");
    check_ids(cells.offsets, "offsets");
    check_ids(cells.connectivity, "connectivity");
    if (cells.offsets.rows() != cells.types.rows() + 1) fail("offsets must have one entry more than types");
    for (std::size_t cell = 0; cell < cells.types.rows(); ++cell) {
        const std::int64_t type = cells.types.integer(cell);
        if (type == static_cast<int>(CellType::polyhedron))
            add_polyhedron(cells, cell, lists);
        else if (const VtkShape* shape = find_vtk_shape(type))
            add_shape(*shape, cells, cell, lists);
        else if (std::ranges::find(without_volume, type) != without_volume.end())
            ++lists.skipped;
        else
            fail("cell " + std::to_string(cell) + " has type " + std::to_string(type) + ", which CIEL does not read");
    }
}

} // namespace ciel::detail
