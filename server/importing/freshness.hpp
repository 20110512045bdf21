// When an input to be imported was last changed.
#pragma once

#include <filesystem>
#include <vector>

namespace ciel::importing {

// The newest of the files that its reader reads, as far as their names tell: of an OpenFOAM case (the directory, its
// .foam file or its controlDict) the control dictionary, the meshes and all that is in the time directories, but no
// logs; of a file itself and the PLOT3D grid or solutions beside it, which are read along. An index that names other
// files (PVD, .series, PVTU, an EnSight case) stands for them: programs write it anew with each step. Only times are
// asked for, no file is opened.
[[nodiscard]] std::filesystem::file_time_type last_change(const std::filesystem::path& input);

// Files beside a PLOT3D grid that have a solution's name: NAME.q, NAME.Q, and NAMEq.EXT beside NAMExyz.EXT.
[[nodiscard]] std::vector<std::filesystem::path> plot3d_solutions(const std::filesystem::path& grid);
// The other way round; the first that is there, or empty.
[[nodiscard]] std::filesystem::path plot3d_grid(const std::filesystem::path& solution);

[[nodiscard]] bool is_openfoam_case(const std::filesystem::path& directory);

} // namespace ciel::importing
