// Matches zones, the input's named copies of cells, to cells of the mesh by the coordinates of their corners.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace ciel::importer {

struct Zone {
    std::string name;
    std::vector<Index> cells;    // stored ids, sorted
    std::uint64_t unmatched = 0; // cells of the zone that the mesh does not have
};

[[nodiscard]] std::vector<Zone> match_zones(const FaceMeshView& mesh, const std::vector<DataSet>& zones);

} // namespace ciel::importer
