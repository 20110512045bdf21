// The same work done by CIEL and by one configuration of VTK, in turns, so that both meet the same machine.
#pragma once

#include "bench/case.hpp"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace ciel::vs_vtk {

struct Contender {
    std::string name;
    std::function<std::uint64_t()> run; // returns its triangles (or points, or what the work counts)
    std::function<void()> prepare = {}; // untimed, before each run
};

struct Outcome { // CIEL's time as a share of VTK's best
    double wall = 0, cpu = 0;
};

// Prints both times, and how many times faster CIEL is by wall and by CPU time.
Outcome duel(const std::string& what, const Contender& ciel, const std::vector<Contender>& vtk);

// In the order of the source, as a reader would have made it.
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> as_grid(const bench::Case& data);
// The case's values as the grid's point scalars, replaced.
void set_values(vtkUnstructuredGrid* grid, const bench::Case& data, const std::vector<float>& values);
[[nodiscard]] bool is_linear(const bench::Case& data); // tetrahedra, hexahedra, wedges and pyramids only

// `many` surfaces or slices in a row.
void surfaces(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many);
void slices(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many);
void gradients(const bench::Case& data, vtkUnstructuredGrid* grid);
void memory(const bench::Case& data, vtkUnstructuredGrid* grid);

} // namespace ciel::vs_vtk
