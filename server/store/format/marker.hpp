// The commit marker, steps.json: the list of steps that readers may see. Whatever else lies in the directory does not
// exist for them. It is only ever replaced whole.
#pragma once

#include "store/format/dataset_info.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace ciel::store {

struct MarkedArray {
    std::uint64_t chunk = 0;
    std::string checksum;                // empty: not given (written with plain Zarr)
    std::optional<ArrayStep> statistics; // not given: the reader makes them
    bool lazy = false;                   // the chunk may not be there yet
};

struct MarkedStep {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::map<std::string, MarkedArray> arrays;
};

struct Marker {
    std::size_t meshes = 0;
    std::vector<MarkedStep> steps;
};

// Throws Error naming `file` and the place. Times must increase, meshes exist, chunks default to the number of earlier
// steps on the same mesh.
[[nodiscard]] Marker parse_marker(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const Marker& marker);

} // namespace ciel::store
