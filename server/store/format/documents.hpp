// Reads the JSON documents that describe a dataset: the root attributes and the commit marker.
#pragma once

#include "store/format/marker.hpp"

namespace server::store {

struct Documents {
    DatasetInfo info; // `arrays` and `meshes` are empty
    Marker marker;
};

// Reads the documents. Opens no array. Throws Error that names the file when the directory is not a dataset, when a
// document is damaged, or when the format version is newer.
[[nodiscard]] Documents read_documents(const std::filesystem::path& directory);

} // namespace server::store
