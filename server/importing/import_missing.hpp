// Imports the inputs of a server that are no datasets yet.
#pragma once

#include "importing/importer.hpp"

namespace ciel::importing {

struct Servable {
    std::filesystem::path path;
    std::filesystem::path input; // that was to be imported to `path`; empty for a dataset or folder of the user
    std::string problem;         // the importer's sentence if the import failed; then `path` does not exist
};

// Returns datasets, and folders other than OpenFOAM cases, unchanged. Imports everything else to folder/KEY/NAME.ciel,
// unless that exists and the input has not changed since (freshness.hpp). KEY is a checksum of the input's path, NAME
// is the name of the input without extension. A file beside the dataset names the input (store/imported_copy.hpp).
// Throws Error for a path that does not exist, before any import, and when `cancel` is set during an import.
[[nodiscard]] std::vector<Servable> import_missing(const std::vector<std::filesystem::path>& data,
                                                   const std::filesystem::path& folder, const ImportLimits& limits,
                                                   const ImportListener& listener, const std::atomic<bool>& cancel);

} // namespace ciel::importing
