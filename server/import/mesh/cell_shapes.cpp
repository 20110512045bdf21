#include "import/mesh/cell_shapes.hpp"

#include <algorithm>
#include <vtkCellType.h>

namespace ciel::importer {

namespace {

constexpr CellShape shapes[] = {
    {VTK_TETRA, CellType::tetrahedron, 4, 4, nullptr},
    {VTK_VOXEL, CellType::hexahedron, 8, 8, nullptr},
    {VTK_HEXAHEDRON, CellType::hexahedron, 8, 8, nullptr},
    {VTK_WEDGE, CellType::wedge, 6, 6, nullptr},
    {VTK_PYRAMID, CellType::pyramid, 5, 5, nullptr},
    {VTK_PENTAGONAL_PRISM, CellType::polyhedron, 10, 10, nullptr},
    {VTK_HEXAGONAL_PRISM, CellType::polyhedron, 12, 12, nullptr},
    {VTK_QUADRATIC_TETRA, CellType::tetrahedron, 4, 10, "quadratic tetrahedra"},
    {VTK_QUADRATIC_HEXAHEDRON, CellType::hexahedron, 8, 20, "quadratic hexahedra"},
    {VTK_TRIQUADRATIC_HEXAHEDRON, CellType::hexahedron, 8, 27, "triquadratic hexahedra"},
    {VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, CellType::hexahedron, 8, 24, "quadratic hexahedra"},
    {VTK_QUADRATIC_WEDGE, CellType::wedge, 6, 15, "quadratic wedges"},
    {VTK_QUADRATIC_LINEAR_WEDGE, CellType::wedge, 6, 12, "quadratic wedges"},
    {VTK_BIQUADRATIC_QUADRATIC_WEDGE, CellType::wedge, 6, 18, "quadratic wedges"},
    {VTK_QUADRATIC_PYRAMID, CellType::pyramid, 5, 13, "quadratic pyramids"},
    {VTK_TRIQUADRATIC_PYRAMID, CellType::pyramid, 5, 19, "quadratic pyramids"},
    {VTK_LAGRANGE_TETRAHEDRON, CellType::tetrahedron, 4, 4, "Lagrange tetrahedra"},
    {VTK_LAGRANGE_HEXAHEDRON, CellType::hexahedron, 8, 8, "Lagrange hexahedra"},
    {VTK_LAGRANGE_WEDGE, CellType::wedge, 6, 6, "Lagrange wedges"},
    {VTK_LAGRANGE_PYRAMID, CellType::pyramid, 5, 5, "Lagrange pyramids"},
    {VTK_BEZIER_TETRAHEDRON, CellType::tetrahedron, 4, 4, "Bezier tetrahedra"},
    {VTK_BEZIER_HEXAHEDRON, CellType::hexahedron, 8, 8, "Bezier hexahedra"},
    {VTK_BEZIER_WEDGE, CellType::wedge, 6, 6, "Bezier wedges"},
    {VTK_BEZIER_PYRAMID, CellType::pyramid, 5, 5, "Bezier pyramids"},
};

constexpr int surface_types[] = {VTK_TRIANGLE,
                                 VTK_POLYGON,
                                 VTK_PIXEL,
                                 VTK_QUAD,
                                 VTK_QUADRATIC_TRIANGLE,
                                 VTK_QUADRATIC_QUAD,
                                 VTK_QUADRATIC_POLYGON,
                                 VTK_BIQUADRATIC_QUAD,
                                 VTK_BIQUADRATIC_TRIANGLE,
                                 VTK_QUADRATIC_LINEAR_QUAD};

} // namespace

const CellShape* find_shape(int vtk_type) {
    const auto* found = std::find_if(std::begin(shapes), std::end(shapes),
                                     [vtk_type](const CellShape& shape) { return shape.vtk_type == vtk_type; });
    return found == std::end(shapes) ? nullptr : found;
}

Dimension cell_dimension(int vtk_type) {
    if (vtk_type == VTK_POLYHEDRON || find_shape(vtk_type) != nullptr) return Dimension::volume;
    const bool surface =
        std::find(std::begin(surface_types), std::end(surface_types), vtk_type) != std::end(surface_types);
    return surface ? Dimension::surface : Dimension::none;
}

} // namespace ciel::importer
