// Rewrites a dataset of an earlier version in the current format. Earlier versions stored the faces of all cells, and
// no blocks and ranges.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ciel::store {

// Returns whether `path` is a directory that holds a dataset, whatever its version.
[[nodiscard]] bool is_dataset(const std::filesystem::path& path);

// Reads the dataset `from`, writes it as `to`, which may be the same path, and returns sentences on arrays whose values
// are not in `from` and are left out. The new dataset has another id. Throws Error as Dataset::open and Writer do, and
// leaves no dataset then. `progress` is called with the share that is done, 0 to 1, and may throw to cancel.
[[nodiscard]] std::vector<std::string> rewrite(const std::filesystem::path& from, const std::filesystem::path& to,
                                               bool overwrite, const std::function<void(double share)>& progress);

} // namespace ciel::store
