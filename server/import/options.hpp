// What the command line asks for.
#pragma once

#include "import/source.hpp"

namespace ciel::importer {

enum class Weld { seams, none, all }; // seams: opposite faces of one structured block

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
