// Imports those inputs of a server that are not datasets.
#pragma once

#include "importing/importer.hpp"

namespace server::importing {

struct Servable {
    std::filesystem::path path;
    std::filesystem::path input; // input of the import to `path`; empty for a dataset or folder of the user
    std::string problem;         // the importer's sentence if the import failed; then `path` does not exist
};

// Datasets, and folders other than OpenFOAM cases, are returned unchanged. Everything else is imported to
// folder/KEY/NAME.ciel, unless such an import exists and the input has not changed since (freshness.hpp). KEY is a
// checksum of the input's path. A file beside the dataset records this path (store/imported_copy.hpp). Throws Error
// before any import if a path does not exist, and if `cancel` is set during an import.
[[nodiscard]] std::vector<Servable> import_missing(const std::vector<std::filesystem::path>& data,
                                                   const std::filesystem::path& folder, const ImportLimits& limits,
                                                   const ImportListener& listener, const std::atomic<bool>& cancel);

} // namespace server::importing
