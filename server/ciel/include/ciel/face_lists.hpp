// Faces of one cell as loops of vertex ids. Face f has the vertices face_vertex[face_offset[f]] to
// face_vertex[face_offset[f + 1] - 1]. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Appends the n + 2 faces of a prism over a polygon of n corners. corners: 2 n vertex ids, first the bottom polygon,
// then the top one in the same direction. All faces are wound outwards, or all inwards, depending on that direction.
void append_prism_faces(std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex);

// Returns the standard type that a cell with these faces has, or polyhedron. Does not use the type that the input file
// gives. face_offset: one more entry than the cell has faces.
[[nodiscard]] CellType type_of_cell(std::span<const std::uint64_t> face_offset, std::span<const Index> face_vertex);

} // namespace ciel
