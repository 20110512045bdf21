// vs_vtk NAME.ciel [--array A]: the same work by CIEL and by VTK's best configurations, alternating within one run.
#include "vs_vtk/duel.hpp"

#include "ciel/parallel.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <vtkObject.h>
#include <vtkVersion.h>

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): a bench ends loudly
    CLI::App app{"CIEL against VTK on one dataset.", "vs_vtk"};
    std::string dataset, array;
    app.add_option("dataset", dataset, "NAME.ciel")->required();
    app.add_option("--array", array, "A scalar on the points");
    CLI11_PARSE(app, argc, argv);
    const ciel::bench::Case data = ciel::bench::open_case(dataset, array);
    std::printf("%s, %s, %u cells, %u threads, VTK %s\n", dataset.c_str(), data.array.c_str(), data.mesh.cell_count(),
                ciel::thread_count(), vtkVersion::GetVTKVersion());
    vtkObject::GlobalWarningDisplayOff(); // its gradients fail in collapsed cells, thousands of times
    const auto grid = ciel::vs_vtk::as_grid(data);
    ciel::vs_vtk::memory(data, grid);
    ciel::vs_vtk::surfaces(data, grid);
    ciel::vs_vtk::slices(data, grid);
    ciel::vs_vtk::gradients(data, grid);
    return 0;
}
