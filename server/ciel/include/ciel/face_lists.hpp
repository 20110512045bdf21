// The faces of one cell as loops in shared lists: face f has the vertices face_vertex[face_offset[f]] to
// face_vertex[face_offset[f + 1] - 1]. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Appends the faces of a prism over a polygon of n corners: bottom 0 to n - 1, top n to 2 n - 1. All are wound
// outwards, or all inwards.
void append_prism_faces(std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex);

// Returns the standard type that the cell's faces make, whatever its file calls it; polyhedron for any other cell.
// face_offset: one more entry than the cell has faces.
[[nodiscard]] CellType type_of_cell(std::span<const std::uint64_t> face_offset, std::span<const Index> face_vertex);

} // namespace ciel
