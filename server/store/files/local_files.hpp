// Tells files on this machine's disks from those of other machines. A mapped page of the latter can be lost at any
// time, when the other machine or the network ends; a call that reads then returns an error.
#pragma once

#include <filesystem>

namespace ciel::store {

// Returns whether the file system that holds `path` is one of this machine. If it cannot be examined: true.
[[nodiscard]] bool is_on_this_machine(const std::filesystem::path& path);

} // namespace ciel::store
