// Example: extracts an iso-surface, a sphere, from a grid of hexahedra in one call.
#include "grid.hpp"

#include <ciel/contour.hpp>

#include <cmath>
#include <cstdio>

int main() {
    const Grid grid = make_grid(40);
    const ciel::Mesh mesh = ciel::Mesh::from_cells(
        {grid.points, 3}, {.types = grid.types, .offsets = grid.offsets, .connectivity = grid.connectivity});
    std::vector<double> radius;
    for (std::size_t i = 0; i < grid.points.size(); i += 3)
        radius.push_back(std::hypot(grid.points[i], grid.points[i + 1], grid.points[i + 2]));

    const ciel::Surface sphere = ciel::contour(mesh, radius, 0.53);
    std::printf("%zu polygons, %zu points, %zu triangles\n", sphere.polygon_cell.size(), sphere.positions.size(),
                ciel::triangulate(sphere).size() / 3);
}
