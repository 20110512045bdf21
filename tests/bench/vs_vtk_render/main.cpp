// vs_vtk_render NAME.ciel [--array A] [--table volume|frames]: compares pictures by CIEL and by VTK's best
// configurations in one process, in alternating runs. Needs an X server, for example xvfb-run.
#include "vs_vtk_render/pictures.hpp"

#include "ciel/parallel.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vtkObject.h>
#include <vtkVersion.h>

namespace ciel::vs_vtk {

void compare(const Outcome& outcome, const Asked& asked) {
    std::printf(
        "    CIEL needs %.2f of VTK's best time, %.2f of its CPU time; asked for: %.3g at most, %.3g hoped for\n",
        outcome.wall, outcome.cpu, asked.must, asked.hoped);
}

void compare_covered(double ciel, double vtk) {
    std::printf("    covered by CIEL %.2f %%, by VTK %.2f %% of the picture\n", 100 * ciel, 100 * vtk);
    constexpr double least = 0.02, most = 0.95, difference = 0.02;
    if (ciel < least || ciel > most || std::abs(ciel - vtk) > difference)
        throw Error("the two pictures do not show the same; their times cannot be compared");
}

} // namespace ciel::vs_vtk

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): an exception may end the program
    CLI::App app{"CIEL's pictures against VTK's of one dataset.", "vs_vtk_render"};
    std::string dataset, array;
    std::vector<std::string> tables{"volume", "frames"};
    app.add_option("dataset", dataset, "NAME.ciel")->required();
    app.add_option("--array", array, "A scalar on the points");
    app.add_option("--table", tables, "Only these")->check(CLI::IsMember(tables))->take_all();
    CLI11_PARSE(app, argc, argv);
    if (std::getenv("DISPLAY") == nullptr) {
        std::fprintf(stderr, "VTK draws through an X server only; run this as xvfb-run -a vs_vtk_render ...\n");
        return 1;
    }
    const server::bench::Case data = server::bench::open_case(dataset, array);
    server::limits::Memory memory(
        UINT64_MAX, [] { return std::uint64_t{0}; }, [] {});
    server::engine::FrameWorkers drawing(1, server::render::Backend::automatic, memory);
    const std::string gl = drawing.run([](server::engine::Worker& worker) { return worker.renderer().gl_renderer(); });
    std::printf("%s, %s, %u cells, %u threads, VTK %s, CIEL's GL %s\n", dataset.c_str(), data.array.c_str(),
                data.mesh.cell_count(), ciel::thread_count(), vtkVersion::GetVTKVersion(), gl.c_str());
    vtkObject::GlobalWarningDisplayOff();
    const auto grid = ciel::vs_vtk::as_grid(data);
    const auto wanted = [&](const char* table) { return std::ranges::find(tables, table) != tables.end(); };
    if (wanted("volume")) ciel::vs_vtk::volumes(data, grid, drawing);
    if (wanted("frames")) ciel::vs_vtk::frames(data, grid, drawing);
    return 0;
}
