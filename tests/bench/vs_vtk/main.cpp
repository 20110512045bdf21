// vs_vtk NAME.ciel [--array A] [--table T]: compares CIEL with VTK's best configurations in one process, in alternating
// runs.
#include "vs_vtk/duel.hpp"
#include "vs_vtk/smp_backend.hpp"

#include "ciel/parallel.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <vtkObject.h>
#include <vtkVersion.h>

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): an exception may end the program
    CLI::App app{"CIEL against VTK on one dataset.", "vs_vtk"};
    std::string dataset, array;
    app.add_option("dataset", dataset, "NAME.ciel")->required();
    app.add_option("--array", array, "A scalar on the points");
    std::vector<std::string> tables{"memory", "surfaces", "clips", "slices", "gradients"};
    app.add_option("--table", tables, "Only these")->check(CLI::IsMember(tables))->take_all();
    std::size_t many = 0;
    app.add_option("--many", many,
                   "Surfaces in a row (100; 3 of arbitrary polyhedra, which take VTK before 9.7 minutes) and slices "
                   "(100; 10)")
        ->check(CLI::Range(2, 1000)); // at least two, because VTK caches the surface of a single value
    CLI11_PARSE(app, argc, argv);
    const server::bench::Case data = server::bench::open_case(dataset, array);
    std::printf("%s, %s, %u cells, %u threads, VTK %s (%s)\n", dataset.c_str(), data.array.c_str(),
                data.mesh.cell_count(), ciel::thread_count(), vtkVersion::GetVTKVersion(), ciel::vs_vtk::smp_backend());
    vtkObject::GlobalWarningDisplayOff(); // VTK's gradients print thousands of warnings about collapsed cells
    const auto grid = ciel::vs_vtk::as_grid(data);
    const auto wanted = [&](const char* table) { return std::ranges::find(tables, table) != tables.end(); };
    const auto or_else = [&](std::size_t linear, std::size_t polyhedra) {
        if (many > 0) return many;
        return ciel::vs_vtk::takes_linear_filter(grid) ? linear : polyhedra;
    };
    if (wanted("memory")) ciel::vs_vtk::memory(data, grid);
    if (wanted("surfaces")) ciel::vs_vtk::surfaces(data, grid, or_else(100, 3));
    if (wanted("clips")) ciel::vs_vtk::clips(data, grid);
    if (wanted("slices")) ciel::vs_vtk::slices(data, grid, or_else(100, 10));
    if (wanted("gradients")) ciel::vs_vtk::gradients(data, grid);
    return 0;
}
