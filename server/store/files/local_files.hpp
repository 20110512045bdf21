// Tells files on this machine's disks from those of other machines. A mapped page of a remote file can be lost at any
// time, when the other machine or the network fails. A call that reads the file returns an error instead.
#pragma once

#include <filesystem>

namespace ciel::store {

// Returns whether the file system that holds `path` is one of this machine. If it cannot be examined: true.
[[nodiscard]] bool is_on_this_machine(const std::filesystem::path& path);

// mapped: a file is used where it is mapped, and all processes share its pages. read: a process copies the parts that
// it uses.
enum class FileAccess { mapped, read };
// Returns `read` for files of other machines, because their mapped pages can be lost at any time.
[[nodiscard]] inline FileAccess access_to(const std::filesystem::path& directory) {
    return is_on_this_machine(directory) ? FileAccess::mapped : FileAccess::read;
}

} // namespace ciel::store
