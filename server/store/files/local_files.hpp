// Distinguishes files on this machine's disks from files on other machines. When the other machine or the network
// fails, an access to the mapped memory of a remote file raises SIGBUS. A read call returns an error instead.
#pragma once

#include <filesystem>

namespace server::store {

// Also returns true if the file system cannot be examined.
[[nodiscard]] bool is_on_this_machine(const std::filesystem::path& path);

// Returns whether files in this folder are kept in memory (tmpfs). No limit of a process counts such memory.
[[nodiscard]] bool is_in_memory(const std::filesystem::path& folder);

// mapped: uses the mapped memory of a file, which all processes share. read: copies the needed bytes of a file.
enum class FileAccess { mapped, read };
[[nodiscard]] inline FileAccess access_to(const std::filesystem::path& directory) {
    return is_on_this_machine(directory) ? FileAccess::mapped : FileAccess::read;
}

} // namespace server::store
