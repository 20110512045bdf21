#include "import/mesh/cell_dimension.hpp"

#include "ciel/vtk_shapes.hpp"

#include <algorithm>
#include <vtkCellType.h>

namespace server::importer {

namespace {

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

Dimension cell_dimension(int vtk_type) {
    if (vtk_type == VTK_POLYHEDRON || ciel::find_vtk_shape(vtk_type) != nullptr) return Dimension::volume;
    const bool surface =
        std::find(std::begin(surface_types), std::end(surface_types), vtk_type) != std::end(surface_types);
    return surface ? Dimension::surface : Dimension::none;
}

} // namespace server::importer
