// Prints the listing of `ciel import --list`.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// Reads only the first step.
void print_listing(Source& source);

} // namespace ciel::importer
