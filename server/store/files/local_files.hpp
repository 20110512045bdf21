// Tells files on this machine's disks from those of other machines. A mapped page of the latter can be lost at any
// time, when the other machine or the network ends; a call that reads then returns an error.
#pragma once

#include <filesystem>

namespace ciel::store {

// Returns whether the file system that holds `path` is one of this machine. If it cannot be examined: true.
[[nodiscard]] bool is_on_this_machine(const std::filesystem::path& path);

// mapped: a file is used where it is mapped, and all processes share its pages. read: a process copies the parts that
// it uses.
enum class FileAccess { mapped, read };
// Returns `read` for the files of other machines, because a page of theirs can be lost at any time.
[[nodiscard]] inline FileAccess access_to(const std::filesystem::path& directory) {
    return is_on_this_machine(directory) ? FileAccess::mapped : FileAccess::read;
}

} // namespace ciel::store
