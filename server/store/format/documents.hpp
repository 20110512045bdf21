// Reads the text files of a dataset that list its content: attributes and commit marker.
#pragma once

#include "store/format/marker.hpp"

namespace ciel::store {

struct Documents {
    DatasetInfo info; // `arrays` and `meshes` are empty
    Marker marker;
};

// Reads the documents without opening an array. Throws Error that names the file when the directory is not a dataset,
// is damaged or has a newer format version.
[[nodiscard]] Documents read_documents(const std::filesystem::path& directory);

} // namespace ciel::store
