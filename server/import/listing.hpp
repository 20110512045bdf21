// Prints the listing of `ciel import --list`.
#pragma once

#include "import/source/source.hpp"

namespace server::importer {

// Reads only the first step.
void print_listing(Source& source);

} // namespace server::importer
