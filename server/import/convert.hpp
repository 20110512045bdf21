// Converts an opened input to a dataset on disk.
#pragma once

#include "import/mesh/welds.hpp"
#include "import/source/source.hpp"

#include <string>
#include <vector>

namespace server::importer {

struct Options {
    std::vector<std::string> inputs;
    std::string output;
    std::vector<std::string> arrays; // names of arrays to import; empty: all arrays
    Weld weld = Weld::seams;
    bool list = false;
    bool allow_bad = false;
    bool force = false;
    SourceOptions source;
};

struct ConvertResult {
    std::vector<std::string> notes;
    std::vector<std::string> lost; // the sentences in `notes` that report data missing from the dataset
    std::uint64_t cells = 0;
    std::uint64_t bad_cells = 0;
};

// Writes the dataset options.output. Leaves out steps that cannot be read. Throws Error, and writes no dataset, if no
// step can be read or the dataset cannot be written.
[[nodiscard]] ConvertResult convert(Source& source, const Options& options);

} // namespace server::importer
