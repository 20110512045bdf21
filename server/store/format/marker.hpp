// The commit marker, steps.json: the list of the steps that readers see, or of the last ones and the facts of the table
// that has the others (step_table.hpp). Readers ignore chunks that it does not list. Writers only replace it as a
// whole.
#pragma once

#include "store/format/dataset_info.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace ciel::store {

struct MarkedArray {
    std::uint64_t chunk = 0;
    std::string checksum;                // empty if not given, as for chunks written with plain Zarr
    std::optional<ArrayStep> statistics; // nullopt if not given; the reader then computes them
    bool lazy = false;                   // the chunk need not be written yet
};

struct MarkedStep {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::map<std::string, MarkedArray> arrays;
};

struct TableArray {
    std::string name;
    std::vector<std::uint64_t> meshes; // those that have steps with the array
};

struct TableFacts {
    std::uint64_t steps = 0; // 0: there is no table
    std::string checksum;    // of the rows
    std::vector<TableArray> arrays;
    std::vector<std::uint64_t> chunks; // by mesh: number after the last chunk; 0 for meshes without an entry
};

struct Marker {
    std::size_t meshes = 0;
    TableFacts table;
    std::vector<MarkedStep> steps; // after those of the table
};

// Throws Error that names `file` and the place in it, also when times do not increase or a step is on a mesh that does
// not exist. `chunk` defaults to the number in the table's `chunks` plus that of earlier steps of the marker on the
// same mesh.
[[nodiscard]] Marker parse_marker(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const Marker& marker);

} // namespace ciel::store
