// The time of the last change of an input to import.
#pragma once

#include <filesystem>
#include <vector>

namespace ciel::importing {

// Returns the newest modification time of the files that the reader reads, as far as their names tell. For an OpenFOAM
// case (the directory, its .foam file or its controlDict): the control dictionary, the meshes and the time directories,
// but no logs. For a file: itself, and the PLOT3D grid or solutions beside it.
// An index that names other files (PVD, .series, PVTU, an EnSight case) stands for them, since programs rewrite it with
// each step. Opens no file.
[[nodiscard]] std::filesystem::file_time_type last_change(const std::filesystem::path& input);

// Existing PLOT3D solutions beside a grid: NAME.q, NAME.Q, and NAMEq.EXT beside NAMExyz.EXT.
[[nodiscard]] std::vector<std::filesystem::path> plot3d_solutions(const std::filesystem::path& grid);
// The first existing PLOT3D grid beside a solution, or empty.
[[nodiscard]] std::filesystem::path plot3d_grid(const std::filesystem::path& solution);

[[nodiscard]] bool is_openfoam_case(const std::filesystem::path& directory);

} // namespace ciel::importing
