// Converts an opened input to a dataset on disk.
#pragma once

#include "import/mesh/welds.hpp"
#include "import/source/source.hpp"

#include <string>
#include <vector>

namespace ciel::importer {

// The options of ciel-import's command line.
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

struct ConvertResult {
    std::vector<std::string> notes;
    std::vector<std::string> lost; // those notes that report data missing from the dataset
    std::uint64_t cells = 0;
    std::uint64_t bad_cells = 0;
};

// Writes options.output without the steps that cannot be read. Throws Error, and leaves no dataset, if no step can be
// read or the dataset cannot be written.
[[nodiscard]] ConvertResult convert(Source& source, const Options& options);

} // namespace ciel::importer
