// What `ciel serve` is given may be foreign files: they are imported once and found again at the next start.
#pragma once

#include <filesystem>

namespace ciel::app {

// `path` itself when it is a dataset or a folder of datasets. Else the dataset that was imported from it into `folder`,
// now (the log shows the progress) or earlier, while the path, its size and its time of change are the same. Throws
// Error when it cannot be imported.
[[nodiscard]] std::filesystem::path import_once(const std::filesystem::path& path, const std::filesystem::path& folder);

// $XDG_CACHE_HOME/ciel, or .cache/ciel in the home directory.
[[nodiscard]] std::filesystem::path default_import_folder();

} // namespace ciel::app
