// Finds the cells of zones, which are named copies of cells in the input, by the coordinates of the corners.
#pragma once

#include "ciel/matched_cells.hpp"
#include "import/mesh/joined_mesh.hpp"

namespace server::importer {

struct Zone {
    std::string name;
    std::vector<ciel::Index> cells; // cell ids in the mesh, sorted
    std::uint64_t unmatched = 0;    // number of cells of the zone that are not in the mesh
};

// `points`: the positions of the mesh.
[[nodiscard]] std::vector<Zone> match_zones(const ciel::MatchedCells& mesh, const ciel::FaceMeshView& points,
                                            const std::vector<InputGrid>& zones);

} // namespace server::importer
