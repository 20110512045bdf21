// Checks the counts in a legacy VTK file against the size of the file. VTK's reader would allocate any declared size
// and keep reading past the end of the file.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace ciel::importer {

// Reads `file` once and skips binary values of known size. Throws Error naming `name` if a declared count is negative,
// or larger than the number of bytes (for bits: eight times that) in the file. Ignores words that declare nothing.
void check_legacy_vtk_counts(std::istream& file, std::uint64_t file_size, const std::string& name);

} // namespace ciel::importer
