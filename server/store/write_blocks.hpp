// Writes the blocks of a mesh: the records of its topology, and their index.
#pragma once

#include "ciel/matched_cells.hpp"
#include "ciel/topology.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace server::store {

struct BlockSizes {
    ciel::Topology::Options topology = {};
    std::uint64_t most_file_bytes = std::uint64_t{1} << 30; // a file is longer only if a single record is longer
};

// `directory`: of the mesh; must exist. bounds: xmin xmax ymin ymax zmin zmax of the first coordinate set. Builds the
// topology and writes each record as soon as it is complete. Throws Error when the mesh is damaged or a file cannot be
// written.
ciel::TopologyCounts write_blocks(const std::filesystem::path& directory, const ciel::FaceMeshView& mesh,
                                  const std::string& dataset_id, const std::array<double, 6>& bounds,
                                  const BlockSizes& sizes = {});
ciel::TopologyCounts write_blocks(const std::filesystem::path& directory, const ciel::MatchedCells& cells,
                                  const std::string& dataset_id, const std::array<double, 6>& bounds,
                                  const BlockSizes& sizes = {});

} // namespace server::store
