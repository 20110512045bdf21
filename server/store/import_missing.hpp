// What a server is asked to serve, made servable.
#pragma once

#include "store/importer.hpp"

namespace ciel::store {

// Datasets, and folders that hold some, come back as they are. Everything else is imported to folder/NAME.ciel, where
// NAME is the input's name without its extension, unless a dataset not older than the input stands there. Several
// inputs of one NAME are refused. Throws Error with the importer's sentence at the first input that cannot be imported.
[[nodiscard]] std::vector<std::filesystem::path>
import_missing(const std::vector<std::filesystem::path>& data, const std::filesystem::path& folder,
               const ImportLimits& limits, const ImportListener& listener, const std::atomic<bool>& cancel);

} // namespace ciel::store
