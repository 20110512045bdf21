// The time of the last change of an input to import.
#pragma once

#include <filesystem>
#include <vector>

namespace server::importing {

// Returns the newest modification time of the files that an import of `input` reads. Opens no file. For an OpenFOAM
// case, these are the controlDict, the meshes and the time directories. For a PLOT3D file, they include its grid or its
// solutions in the same directory. For an index of other files (PVD, .series, PVTU, EnSight case), this is only the
// index, because programs rewrite the index at each step.
[[nodiscard]] std::filesystem::file_time_type last_change(const std::filesystem::path& input);

// Returns the existing PLOT3D solutions in the directory of a grid: NAME.q, NAME.Q, and for NAMExyz.EXT also NAMEq.EXT.
[[nodiscard]] std::vector<std::filesystem::path> plot3d_solutions(const std::filesystem::path& grid);
// Returns the first existing PLOT3D grid in the directory of a solution; empty if there is none.
[[nodiscard]] std::filesystem::path plot3d_grid(const std::filesystem::path& solution);

[[nodiscard]] bool is_openfoam_case(const std::filesystem::path& directory);

} // namespace server::importing
