// The options of ciel-import's command line.
#pragma once

#include "import/mesh/welds.hpp"
#include "import/source/source.hpp"

#include <string>
#include <vector>

namespace ciel::importer {

struct Options {
    std::vector<std::string> inputs;
    std::string output;
    std::vector<std::string> arrays; // empty: all
    Weld weld = Weld::seams;
    bool list = false;
    bool allow_bad = false;
    bool force = false;
    SourceOptions source;
};

} // namespace ciel::importer
