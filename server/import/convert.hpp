// From an opened input to a dataset on disk.
#pragma once

#include "import/options.hpp"

namespace ciel::importer {

struct ConvertResult {
    std::vector<std::string> notes;
    std::vector<std::string> lost; // of the notes: what the input has, or should have, and the dataset has not
    std::uint64_t cells = 0;
    std::uint64_t bad_cells = 0;
};

// Writes options.output. A step that cannot be read is lost, and the others are written. Throws Error where none can,
// or where the dataset cannot be written; nothing is left then.
[[nodiscard]] ConvertResult convert(Source& source, const Options& options);

} // namespace ciel::importer
