// Example: extracts three levels at each of three time steps. The topology is built once.
#include "grid.hpp"

#include <ciel/contour.hpp>

#include <cmath>
#include <cstdio>

int main() {
    const Grid grid = make_grid(40);
    const ciel::Mesh mesh = ciel::Mesh::from_cells(
        {grid.points, 3}, {.types = grid.types, .offsets = grid.offsets, .connectivity = grid.connectivity});
    const auto wave = [&](double time) {
        std::vector<float> values;
        for (std::size_t i = 0; i < grid.points.size(); i += 3)
            values.push_back(static_cast<float>(std::sin(3 * grid.points[i] + time) + grid.points[i + 1]));
        return ciel::Field(mesh, values);
    };

    ciel::Contour slider(wave(0));
    ciel::Surface surface; // at() reuses its buffers
    for (int step = 0; step < 3; ++step) {
        slider.set(wave(0.1 * step));
        for (const double level : {-0.2, 0.0, 0.2}) {
            slider.at(level, surface);
            std::printf("step %d, level %4.1f: %zu polygons\n", step, level, surface.polygon_cell.size());
        }
    }
}
