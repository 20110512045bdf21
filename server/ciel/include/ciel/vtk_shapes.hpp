// VTK's cell types that have a volume and fixed faces, and the faces of these types. VTK lists the corners of a cell
// before its other points (VTK User's Guide, "Cell types"). Of a higher-order cell, only the corners are used. Not in
// the paper.
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace ciel {

struct VtkShape {
    int vtk_type;              // VTK's number of the cell type
    CellType type;             // polyhedron: a prism over a polygon of corners / 2 points
    std::uint8_t corners;      // number of corners; these are the first points of the cell
    std::uint8_t least_points; // a cell of this type with fewer points is damaged
    const char* reduced_from;  // plural name of higher-order cells, such as "quadratic wedges"; null for linear cells
};

// Returns null for polyhedra, convex point sets, types without volume, and numbers that VTK does not have.
[[nodiscard]] const VtkShape* find_vtk_shape(std::int64_t vtk_type);

using VtkCorners = std::array<Index, 12>; // a hexagonal prism, the shape with the most corners, has 12

// Returns the corners in the order of append_standard_faces. `corners`: the first shape.corners points of the cell.
[[nodiscard]] VtkCorners standard_corners(const VtkShape& shape, VtkCorners corners);

// Appends the faces of a cell (append_standard_faces, append_prism_faces). `corners`: its first shape.corners points.
// `face_offset` must begin with 0; it gets the end of each face in face_vertex.
void append_vtk_faces(const VtkShape& shape, VtkCorners corners, std::vector<std::uint64_t>& face_offset,
                      std::vector<Index>& face_vertex);

} // namespace ciel
