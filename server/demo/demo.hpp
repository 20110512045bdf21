// The demo dataset: Voronoi cells around a cylinder in a conforming bed of hexahedra, and an unsteady vortex street.
#pragma once

#include <filesystem>
#include <functional>

namespace ciel::demo {

// Writes the dataset (at least 100,000 arbitrary polyhedra, at least 20 time steps) in under 20 s on two cores.
// `progress` gets a share in [0, 1] and what is being done. Throws Error.
void write_demo(const std::filesystem::path& directory, bool overwrite,
                const std::function<void(double share, const char* what)>& progress);

} // namespace ciel::demo
