// Compares the time of CIEL and of configurations of VTK for the same work, in alternating runs.
#pragma once

#include "bench/case.hpp"

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace ciel::vs_vtk {
using namespace server;

struct Contender {
    std::string name;
    std::function<std::uint64_t()> run; // returns the number of triangles, or of whatever the work counts
    std::function<void()> prepare = {}; // called before each run, untimed
};

// Time of CIEL divided by that of the fastest VTK configuration.
struct Outcome {
    double wall = 0, cpu = 0;
};

// Prints wall and CPU times, and the factors by which CIEL is faster.
Outcome duel(const std::string& what, const Contender& ciel, const std::vector<Contender>& vtk);

// Cells and points are in the order of the dataset's source, as a reader would give them.
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> as_grid(const bench::Case& data);
// Replaces the grid's point scalars by `values`, reordered to the source's order.
void set_values(vtkUnstructuredGrid* grid, const bench::Case& data, const store::Values& values);
// True when all cells are tetrahedra, hexahedra, wedges or pyramids.
[[nodiscard]] bool is_linear(const bench::Case& data);

// True when vtkContour3DLinearGrid takes the cells: linear ones, and polyhedra from VTK 9.7 on.
[[nodiscard]] bool takes_linear_filter(vtkUnstructuredGrid* grid);

// `many`: number of surfaces or slices in a row.
void surfaces(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many);
void slices(const bench::Case& data, vtkUnstructuredGrid* grid, std::size_t many);
void gradients(const bench::Case& data, vtkUnstructuredGrid* grid);
void clips(const bench::Case& data, vtkUnstructuredGrid* grid);
void memory(const bench::Case& data, vtkUnstructuredGrid* grid);

} // namespace ciel::vs_vtk
