// The counts in a legacy VTK file, held against its size before VTK believes them: its reader makes room for what is
// declared, and goes on reading after the end of the file until it has it.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace ciel::importer {

// Reads the words of `file` once; binary values whose size the file tells are skipped. Throws Error naming `name` when
// a declaration is negative or needs more values than the file has bytes (bits: eight to a byte). What is not a
// declaration is no concern of it.
void check_legacy_vtk_counts(std::istream& file, std::uint64_t file_size, const std::string& name);

} // namespace ciel::importer
