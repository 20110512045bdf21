// The answer to `ciel import --list`.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// Prints what the input holds: format, steps, blocks, arrays. Reads the first step only.
void print_listing(Source& source);

} // namespace ciel::importer
