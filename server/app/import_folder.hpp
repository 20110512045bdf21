// The folders in which CIEL keeps what it imports by itself.
#pragma once

#include <filesystem>

namespace server::app {

// Returns $XDG_CACHE_HOME/ciel, else $HOME/.cache/ciel.
[[nodiscard]] std::filesystem::path default_import_folder();
// Returns the folder for the late arrays of datasets that cannot be written.
[[nodiscard]] inline std::filesystem::path late_folder_in(const std::filesystem::path& import_folder) {
    return std::filesystem::absolute(import_folder / "late");
}

} // namespace server::app
