// Refuses inputs that are absent, and pipes, sockets and devices, before a reader opens them. Opening a pipe could
// block forever.
#pragma once

#include <filesystem>
#include <string_view>

namespace server::importer {

// Throws Error that names the file if it does not exist, or if the system refuses to say so (permissions of a folder).
void require_existing(const std::filesystem::path& file);

// Throws Error that names the file if the file exists and is neither a regular file nor a directory.
void require_regular(const std::filesystem::path& file);

// Checks the entries of a directory, but not of its subdirectories. The directory need not exist.
void require_regular_files(const std::filesystem::path& directory);

void require_regular_files(const std::filesystem::path& directory, std::string_view beginning);

} // namespace server::importer
