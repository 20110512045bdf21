#include "mesh/input_faces.hpp"

#include "mesh/standard_shapes.hpp"

#include <algorithm>
#include <string>

namespace ciel::detail {

namespace {

void check_offsets_of(std::span<const std::uint64_t> offsets, std::uint64_t end, const std::string& name) {
    if (offsets.empty() || offsets.front() != 0 || !std::ranges::is_sorted(offsets) || offsets.back() != end)
        fail(name + " must rise from 0 to " + std::to_string(end) + ", the length of the array that it indexes");
}

} // namespace

InputFaces::InputFaces(const PolyhedraView& input) : input_(input) {
    check_offsets();
    check_cells();
    number_faces();
}

void InputFaces::check_offsets() const {
    if (input_.positions.size() % 3 != 0) fail("positions must hold three numbers per vertex");
    if (input_.positions.size() / 3 >= none || input_.cell_types.size() >= none || input_.face_offset.size() > none)
        fail("the mesh has more than 4,294,967,294 vertices, cells or faces; split the dataset");
    const std::string one_more =
        " must hold one number more than there are cells (" + std::to_string(input_.cell_types.size()) + ")";
    const std::size_t faces = input_.face_offset.empty() ? 0 : input_.face_offset.size() - 1;
    if (!input_.cell_offset.empty() || faces > 0) {
        if (input_.cell_offset.size() != input_.cell_types.size() + 1) fail("cell_offset" + one_more);
        check_offsets_of(input_.cell_offset, faces, "cell_offset");
    }
    check_offsets_of(input_.face_offset, input_.face_vertex.size(), "face_offset");
    if (input_.corner_offset.empty()) return;
    if (input_.corner_offset.size() != input_.cell_types.size() + 1) fail("corner_offset" + one_more);
    check_offsets_of(input_.corner_offset, input_.corner.size(), "corner_offset");
}

void InputFaces::check_cells() const {
    for (Index cell = 0; cell < cell_count(); ++cell) {
        const auto type = static_cast<CellType>(input_.cell_types[cell]);
        std::size_t corners = 0;
        const bool is_standard = with_shape(type, [&]<const StandardShape & shape>() { corners = shape.corners; });
        if (!is_standard && type != CellType::polyhedron)
            fail("cell type " + std::to_string(input_.cell_types[cell]) +
                 " is not known; use 10 (tetrahedron), 12 (hexahedron), 13 (wedge), 14 (pyramid) or 42 (polyhedron)");
        if (!has_corners(cell)) continue;
        if (input_.corner_offset[cell + 1] - input_.corner_offset[cell] != corners || listed_faces(cell) > 0)
            fail("cell " + std::to_string(cell) + " of type " + std::to_string(input_.cell_types[cell]) +
                 " must list either its faces or its " + std::to_string(corners) + " corners");
    }
}

void InputFaces::number_faces() {
    begin_.reserve(input_.cell_types.size() + 1);
    std::uint64_t faces = 0;
    for (Index cell = 0; cell < cell_count(); ++cell) {
        begin_.push_back(static_cast<Index>(faces));
        if (has_corners(cell))
            with_shape(static_cast<CellType>(input_.cell_types[cell]),
                       [&]<const StandardShape & shape>() { faces += shape.faces; });
        else
            faces += listed_faces(cell);
        if (faces >= none) fail("the mesh has more than 4,294,967,294 faces; split the dataset");
    }
    begin_.push_back(static_cast<Index>(faces));
}

// The first guess assumes that all cells have the same number of faces. The search widens around it.
Index InputFaces::cell_of(Index face) const {
    const auto guess = static_cast<Index>(std::uint64_t{face} * cell_count() / face_count());
    Index low = guess, high = guess + 1;
    for (Index step = 1; begin_[low] > face; step *= 2) {
        high = low;
        low -= std::min(low, step);
    }
    for (Index step = 1; begin_[high] <= face; step *= 2) {
        low = high;
        high += std::min(cell_count() - high, step);
    }
    const auto first = begin_.begin() + static_cast<std::ptrdiff_t>(low);
    const auto last = begin_.begin() + static_cast<std::ptrdiff_t>(high);
    return static_cast<Index>(std::upper_bound(first, last, face) - begin_.begin() - 1);
}

std::span<const Index> InputFaces::loop(Index cell, Index face, Corners& scratch) const {
    const Index of_cell = face - begin(cell);
    if (!has_corners(cell)) {
        const std::uint64_t listed = input_.cell_offset[cell] + of_cell, first = input_.face_offset[listed];
        return input_.face_vertex.subspan(first, input_.face_offset[listed + 1] - first);
    }
    const Index* corner = &input_.corner[input_.corner_offset[cell]];
    std::size_t size = 0;
    with_shape(static_cast<CellType>(input_.cell_types[cell]), [&]<const StandardShape & shape>() {
        size = shape.face_size(of_cell);
        for (std::size_t i = 0; i < size; ++i) scratch[i] = corner[shape.origin[shape.face_begin[of_cell] + i]];
    });
    return std::span(scratch).first(size);
}

std::size_t InputFaces::size(Index cell, Index face) const {
    const Index of_cell = face - begin(cell);
    if (!has_corners(cell)) {
        const std::uint64_t listed = input_.cell_offset[cell] + of_cell;
        return input_.face_offset[listed + 1] - input_.face_offset[listed];
    }
    std::size_t size = 0;
    with_shape(static_cast<CellType>(input_.cell_types[cell]),
               [&]<const StandardShape & shape>() { size = shape.face_size(of_cell); });
    return size;
}

} // namespace ciel::detail
