// Rewrites a dataset of an earlier version, which has all faces but no blocks and no ranges, in the current format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace server::store {

[[nodiscard]] bool is_dataset(const std::filesystem::path& path);

// `to` may be the same path. Returns a sentence about each array that is left out because its values are not in `from`.
// The new dataset has another id. Throws Error as Dataset::open and Writer do; no new dataset exists then. `progress`
// is called with the completed share, 0 to 1, and may throw to cancel.
[[nodiscard]] std::vector<std::string> rewrite(const std::filesystem::path& from, const std::filesystem::path& to,
                                               bool overwrite, const std::function<void(double share)>& progress);

} // namespace server::store
