// Writes the blocks of a mesh: the records of its topology, and their index.
#pragma once

#include "ciel/topology.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace server::store {

// `mesh`: an existing directory. bounds: xmin xmax ymin ymax zmin zmax of the first coordinate set. A file of records
// is longer than most_file_bytes only if a single record is longer. Throws Error when a file cannot be written.
void write_blocks(const std::filesystem::path& mesh, const ciel::Topology& topology, const std::string& dataset_id,
                  const std::array<double, 6>& bounds, std::uint64_t most_file_bytes = std::uint64_t{1} << 30);

} // namespace server::store
