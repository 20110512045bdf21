#include "ciel/assemble.hpp"

namespace ciel {

namespace {

// Corners in VTK order; loops wound outwards; -1 ends a loop that is shorter than four.
struct StandardCell {
    CellType type;
    std::size_t corners, faces;
    std::array<std::array<int, 4>, 6> loops;
};

constexpr StandardCell standard_cells[] = {
    {CellType::tetrahedron, 4, 4, {{{0, 1, 3, -1}, {1, 2, 3, -1}, {2, 0, 3, -1}, {0, 2, 1, -1}}}},
    {CellType::hexahedron,
     8,
     6,
     {{{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}}},
    {CellType::wedge, 6, 5, {{{0, 1, 2, -1}, {3, 5, 4, -1}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}}},
    {CellType::pyramid, 5, 5, {{{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}}},
};

const StandardCell& standard_cell(CellType type) {
    for (const StandardCell& cell : standard_cells)
        if (cell.type == type) return cell;
    fail("cell type " + std::to_string(static_cast<int>(type)) + " is not a standard cell: give its faces one by one");
}

} // namespace

void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex) {
    const StandardCell& cell = standard_cell(type);
    if (corners.size() != cell.corners)
        fail("a cell of type " + std::to_string(static_cast<int>(type)) + " has " + std::to_string(cell.corners) +
             " corners, not " + std::to_string(corners.size()));
    for (std::size_t face = 0; face < cell.faces; ++face) {
        for (const int corner : cell.loops[face])
            if (corner >= 0) face_vertex.push_back(corners[static_cast<std::size_t>(corner)]);
        face_offset.push_back(face_vertex.size());
    }
}

} // namespace ciel
