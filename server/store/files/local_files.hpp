// Distinguishes files on this machine's disks from files on other machines. When the other machine or the network
// fails, an access to a mapped page of a remote file raises SIGBUS. A read call returns an error instead.
#pragma once

#include <filesystem>

namespace ciel::store {

// Returns true if the file system of `path` is on this machine, or if the file system cannot be examined.
[[nodiscard]] bool is_on_this_machine(const std::filesystem::path& path);

// mapped: the process maps a file and uses the mapped pages, which all processes share. read: the process copies the
// parts of a file that it needs into its own memory.
enum class FileAccess { mapped, read };
// Returns `read` if `directory` is on another machine, because an access to a mapped page can then fail at any time.
// Otherwise returns `mapped`.
[[nodiscard]] inline FileAccess access_to(const std::filesystem::path& directory) {
    return is_on_this_machine(directory) ? FileAccess::mapped : FileAccess::read;
}

} // namespace ciel::store
