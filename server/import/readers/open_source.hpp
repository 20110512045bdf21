// Opens an input of any known format.
#pragma once

#include "import/source/source.hpp"

#include <memory>
#include <string>
#include <vector>

namespace server::importer {

// Opens inputs with the reader for their format (formats.cpp). Several inputs are parts of one mesh. PLOT3D inputs are
// a grid and its solutions. Throws Error if an input is missing, has an unknown format, or cannot be read.
[[nodiscard]] std::unique_ptr<Source> open_source(const std::vector<std::string>& inputs, const SourceOptions& options);

} // namespace server::importer
