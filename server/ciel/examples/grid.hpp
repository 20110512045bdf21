// Input of the examples: a grid of hexahedra in the arrays of a vtkUnstructuredGrid.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

struct Grid {
    std::vector<double> points; // x, y, z of each point
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> offsets{0}, connectivity;
};

// Returns a grid of n x n x n cells that fill the cube from -1 to 1.
inline Grid make_grid(int n) {
    Grid grid;
    const int row = n + 1;
    for (int z = 0; z < row; ++z)
        for (int y = 0; y < row; ++y)
            for (int x = 0; x < row; ++x)
                for (const int at : {x, y, z}) grid.points.push_back(2.0 * at / n - 1);
    const auto id = [row](int x, int y, int z) { return std::int64_t{z} * row * row + y * row + x; };
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                for (const int up : {0, 1})
                    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                        grid.connectivity.push_back(id(x + dx, y + dy, z + up));
                grid.types.push_back(12); // VTK_HEXAHEDRON
                grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
            }
    return grid;
}
