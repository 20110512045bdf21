// The commit marker, steps.json, lists the steps that readers see, except the steps in the table of steps
// (step_table.hpp). Readers ignore other chunks. Writers replace the marker as a whole.
#pragma once

#include "store/format/dataset_info.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace server::store {

struct MarkedArray {
    std::uint64_t chunk = 0;
    std::string checksum;                // checksum of the chunk file; empty if the file was written with plain Zarr
    std::optional<ArrayStep> statistics; // nullopt if the marker has no statistics; the reader then computes them
    bool late = false;                   // true: the chunk is written later, when a user needs it
};

struct MarkedStep {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::map<std::string, MarkedArray> arrays;
};

struct TableArray {
    std::string name;
    std::vector<std::uint64_t> meshes; // indices of the meshes that have steps with the array
};

struct TableFacts {
    std::uint64_t steps = 0; // number of steps in the table; 0 if there is no table
    std::string checksum;    // checksum of the table's rows
    std::vector<TableArray> arrays;
    // By mesh: 1 + the number of the last chunk in the table. 0 for a mesh without an entry.
    std::vector<std::uint64_t> chunks;
};

struct Marker {
    std::size_t meshes = 0;
    TableFacts table;
    std::vector<MarkedStep> steps; // the steps after the steps of the table
};

// Throws Error that names `file` and the path of the wrong value in the document. Also throws Error when times do not
// increase, or when a step is on a mesh that does not exist. If an array has no `chunk`, its chunk number is a + b. a
// is the entry of the step's mesh in the table's `chunks`. b is the number of earlier steps on this mesh in the marker.
[[nodiscard]] Marker parse_marker(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const Marker& marker);

// Read and write the file of facts beside a late chunk. It has the data that the marker has for other arrays. nullopt:
// the source has no such array at this step. parse_late_facts throws Error that names `file` when the text is damaged.
[[nodiscard]] std::optional<MarkedArray> parse_late_facts(std::string_view text, const std::filesystem::path& file,
                                                          std::uint64_t chunk);
[[nodiscard]] std::string late_facts_text(const std::optional<MarkedArray>& array);

} // namespace server::store
