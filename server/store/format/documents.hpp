// The text files that say what a dataset holds now.
#pragma once

#include "store/format/marker.hpp"

namespace ciel::store {

struct Documents {
    DatasetInfo info; // without arrays and meshes
    Marker marker;
};

// Cheap: maps nothing. Throws Error naming the file when the directory is no dataset, damaged or of a newer version.
[[nodiscard]] Documents read_documents(const std::filesystem::path& directory);

} // namespace ciel::store
