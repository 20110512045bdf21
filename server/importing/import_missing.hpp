// What a server is asked to serve, made servable.
#pragma once

#include "importing/importer.hpp"

namespace ciel::importing {

struct Servable {
    std::filesystem::path path;
    std::string problem; // the importer's sentence, when it could not be imported; nothing stands at `path` then
};

// Datasets, and folders other than OpenFOAM cases, come back as they are. Everything else is imported to
// folder/KEY/NAME.ciel, where KEY stands for the input's path and NAME is its name without extension, unless it stands
// there and the input has not been changed since (freshness.hpp). A file beside the copy says what it is one of. Throws
// Error for a path that does not exist, before anything is imported, and when `cancel` is set.
[[nodiscard]] std::vector<Servable> import_missing(const std::vector<std::filesystem::path>& data,
                                                   const std::filesystem::path& folder, const ImportLimits& limits,
                                                   const ImportListener& listener, const std::atomic<bool>& cancel);

} // namespace ciel::importing
