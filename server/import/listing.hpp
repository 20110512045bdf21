// Prints the listing of `ciel import --list`.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// Prints the format, steps, blocks, surfaces, zones and arrays of the input. Reads only the first step.
void print_listing(Source& source);

} // namespace ciel::importer
