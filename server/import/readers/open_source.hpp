// Opens an input of any known format.
#pragma once

#include "import/source/source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace ciel::importer {

// Finds the reader (formats.cpp has the table). One input, or several: parts of one mesh, except for PLOT3D where they
// are the grid and its solution. Throws Error when an input is missing, of no known format, or cannot be read.
[[nodiscard]] std::unique_ptr<Source> open_source(const std::vector<std::string>& inputs, const SourceOptions& options);

} // namespace ciel::importer
