// Faces of one cell as loops of vertex ids. Face f has the vertices face_vertex[face_offset[f]] to
// face_vertex[face_offset[f + 1] - 1]. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Appends the n + 2 faces of a prism over a polygon of n corners. `corners`: 2 n vertex ids, first the bottom polygon,
// then the top polygon in the same direction. The faces are wound outwards if the polygons run counter-clockwise seen
// from above, else all are wound inwards. `face_offset` must begin with 0; it gets the end of each face in face_vertex.
void append_prism_faces(std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex);

// Returns the standard type that a cell with these faces has, or polyhedron. Ignores the type that the input file
// gives. `face_offset`: one more entry than the cell has faces.
[[nodiscard]] CellType type_of_cell(std::span<const std::uint64_t> face_offset, std::span<const Index> face_vertex);

} // namespace ciel
