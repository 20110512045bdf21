// Checks the counts in a legacy VTK file against the size of the file. Without this check, VTK's reader would allocate
// any declared size and continue to read after the end of the file.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace server::importer {

// Throws Error if a declared count is negative, or larger than the number of bytes in the file. A count of bits may be
// eight times as large. Error texts start with `name`.
void check_legacy_vtk_counts(std::istream& file, std::uint64_t file_size, const std::string& name);

} // namespace server::importer
