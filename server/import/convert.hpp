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
    bool all = false;               // write all steps; if the input is a dataset, read all its late steps
    std::vector<std::size_t> steps; // late steps to read; only if the input is a dataset
    std::string late_folder;        // LateOptions::folder
    bool allow_bad = false;
    bool force = false;
    SourceOptions source;
};

// Memory in bytes at the step at which the import needed most memory in addition to that of the reader.
struct MemoryUse {
    std::uint64_t reader = 0; // in use after the step had been read
    std::uint64_t beyond = 0; // highest use while the step was written, less `reader`
    std::uint64_t cells = 0;  // number of cells of the input
};

struct ConvertResult {
    std::vector<std::string> notes;
    std::vector<std::string> lost; // the sentences in `notes` that report data missing from the dataset
    std::uint64_t cells = 0;
    std::uint64_t bad_cells = 0;
    std::size_t late_steps = 0; // number of late steps (store/late_files.hpp)
    MemoryUse memory;
};

// Writes the dataset options.output. Leaves out steps that cannot be read. Throws Error, and writes no dataset, if no
// step can be read or the dataset cannot be written.
[[nodiscard]] ConvertResult convert(Source& source, const Options& options);

} // namespace server::importer
