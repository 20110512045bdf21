// Lists the faces of one cell as loops of vertex ids. Face f has the vertices face_vertex[face_offset[f]] to
// face_vertex[face_offset[f + 1] - 1]. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Appends the n + 2 faces of a prism over a polygon of n corners. `corners`: 2 n vertex ids, first the bottom polygon,
// then the top polygon in the same direction. If the polygons run counter-clockwise seen from above, all faces are
// wound outwards, else inwards. `face_offset` must begin with 0; it gets the end of each face in face_vertex.
void append_prism_faces(std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex);

// Returns the type of a cell with these faces: a standard type, such as hexahedron, or polyhedron. The type in the
// input file has no influence. `face_offset`: one entry more than the cell has faces.
[[nodiscard]] CellType type_of_cell(std::span<const std::uint64_t> face_offset, std::span<const Index> face_vertex);

} // namespace ciel
