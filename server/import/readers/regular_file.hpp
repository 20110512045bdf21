// What a reader is about to open: a pipe, a socket or a device among it would make it wait for ever.
#pragma once

#include <filesystem>
#include <string_view>

namespace ciel::importer {

// Throws Error naming the file where it is there and is neither a regular file nor a directory. Does not open it.
void require_regular(const std::filesystem::path& file);

// The same for all in a directory, but not in those below. Nothing where there is no such directory.
void require_regular_files(const std::filesystem::path& directory);

// The same for those whose names begin in this way.
void require_regular_files(const std::filesystem::path& directory, std::string_view beginning);

} // namespace ciel::importer
