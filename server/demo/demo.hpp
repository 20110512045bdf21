// The demo dataset: Voronoi cells around a cylinder in a conforming bed of hexahedra, and an unsteady vortex street.
#pragma once

#include <filesystem>
#include <functional>

namespace server::demo {

inline constexpr int most_coarseness = 4; // larger cells do not fit between the cylinder and the hexahedra

// Writes the dataset. At coarseness 1 it has at least 100,000 arbitrary polyhedra and 20 time steps, and writing takes
// under 20 s on two cores. coarseness: factor on the length of cells, from 1 to most_coarseness. Arrays, groups and
// times do not depend on the coarseness. `progress` gets a share in [0, 1] and the name of the current stage. Throws
// Error if a cell does not close, if the dataset exists and `overwrite` is false, or if the dataset cannot be written.
void write_demo(const std::filesystem::path& directory, bool overwrite, int coarseness,
                const std::function<void(double share, const char* what)>& progress);

} // namespace server::demo
