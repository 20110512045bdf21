#include "vs_vtk/duel.hpp"

#include <cstdio>
#include <vtkAbstractCellLinks.h>
#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkVersionMacros.h>

namespace ciel::vs_vtk {
using namespace server;

void memory(const bench::Case& data, vtkUnstructuredGrid* grid) {
    const auto half_edges = static_cast<double>(data.topology->counts().half_edges);
    const auto line = [&](const char* what, double bytes) {
        std::printf("    %-54s %14.0f bytes %8.2f per half-edge\n", what, bytes, bytes / half_edges);
    };
    std::printf("  memory\n");
    line("CIEL, six operators", static_cast<double>(data.topology->memory_bytes()));
    constexpr double kib = 1024;
    double cells = kib * static_cast<double>(grid->GetCells()->GetActualMemorySize());
    cells += static_cast<double>(grid->GetNumberOfCells()); // one byte per cell for its type
    if (grid->GetFaces() != nullptr)
        cells += kib * static_cast<double>(grid->GetFaces()->GetActualMemorySize() +
                                           grid->GetFaceLocations()->GetActualMemorySize());
    line("vtkUnstructuredGrid, cells and faces", cells);
    grid->BuildLinks();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    auto* made = grid->GetLinks();
#else
    auto* made = grid->GetCellLinks();
#endif
    // VTK 9.1 and 9.3 return bytes here, although the documentation says kibibytes.
    const double links = static_cast<double>(made->GetActualMemorySize());
    line("with links to the cells of a point", cells + links);
}

} // namespace ciel::vs_vtk
