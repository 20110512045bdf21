// Finds inverted face pyramids. The base of a face pyramid is a face of a cell, and its apex is the cell's center. An
// inverted pyramid has negative volume. The import keeps cells with inverted pyramids, because their winding is
// consistent.
#pragma once

#include "ciel/matched_cells.hpp"

namespace server::importer {

struct InvertedPyramids {
    std::uint64_t count = 0;        // number of inverted pyramids; a cell may have several
    std::vector<ciel::Index> cells; // ids of the cells with inverted pyramids in the mesh, sorted, distinct
};

// `points`: the positions of the mesh.
[[nodiscard]] InvertedPyramids find_inverted_pyramids(const ciel::MatchedCells& mesh, const ciel::FaceMeshView& points);

} // namespace server::importer
