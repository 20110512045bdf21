#include "ciel/vtk_shapes.hpp"

#include "ciel/assemble.hpp"
#include "ciel/face_lists.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace ciel {

namespace {

constexpr int voxel = 11;
constexpr VtkShape shapes[] = {
    {10, CellType::tetrahedron, 4, 4, nullptr},
    {voxel, CellType::hexahedron, 8, 8, nullptr},
    {12, CellType::hexahedron, 8, 8, nullptr},
    {13, CellType::wedge, 6, 6, nullptr},
    {14, CellType::pyramid, 5, 5, nullptr},
    {15, CellType::polyhedron, 10, 10, nullptr}, // pentagonal prism
    {16, CellType::polyhedron, 12, 12, nullptr}, // hexagonal prism
    {24, CellType::tetrahedron, 4, 10, "quadratic tetrahedra"},
    {25, CellType::hexahedron, 8, 20, "quadratic hexahedra"},
    {26, CellType::wedge, 6, 15, "quadratic wedges"},
    {27, CellType::pyramid, 5, 13, "quadratic pyramids"},
    {29, CellType::hexahedron, 8, 27, "triquadratic hexahedra"},
    {31, CellType::wedge, 6, 12, "quadratic wedges"},         // linear along its height
    {32, CellType::wedge, 6, 18, "quadratic wedges"},         // with points in the middle of faces
    {33, CellType::hexahedron, 8, 24, "quadratic hexahedra"}, // with points in the middle of faces
    {37, CellType::pyramid, 5, 19, "quadratic pyramids"},     // with points in the middle of faces
    {71, CellType::tetrahedron, 4, 4, "Lagrange tetrahedra"},
    {72, CellType::hexahedron, 8, 8, "Lagrange hexahedra"},
    {73, CellType::wedge, 6, 6, "Lagrange wedges"},
    {74, CellType::pyramid, 5, 5, "Lagrange pyramids"},
    {78, CellType::tetrahedron, 4, 4, "Bezier tetrahedra"},
    {79, CellType::hexahedron, 8, 8, "Bezier hexahedra"},
    {80, CellType::wedge, 6, 6, "Bezier wedges"},
    {81, CellType::pyramid, 5, 5, "Bezier pyramids"},
};

} // namespace

const VtkShape* find_vtk_shape(std::int64_t vtk_type) {
    const auto* found = std::ranges::find(shapes, vtk_type, &VtkShape::vtk_type);
    return found == std::end(shapes) ? nullptr : found;
}

VtkCorners standard_corners(const VtkShape& shape, VtkCorners corners) {
    if (shape.vtk_type == voxel) {
        std::swap(corners[2], corners[3]);
        std::swap(corners[6], corners[7]);
    }
    return corners;
}

void append_vtk_faces(const VtkShape& shape, VtkCorners corners, std::vector<std::uint64_t>& face_offset,
                      std::vector<Index>& face_vertex) {
    corners = standard_corners(shape, corners);
    const std::span<const Index> used(corners.data(), shape.corners);
    if (shape.type == CellType::polyhedron)
        append_prism_faces(used, face_offset, face_vertex);
    else
        append_standard_faces(shape.type, used, face_offset, face_vertex);
}

} // namespace ciel
