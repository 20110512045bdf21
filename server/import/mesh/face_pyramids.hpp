// Finds inverted face pyramids: the pyramid from a cell's center over one of its faces has negative volume. Cells with
// inverted pyramids are kept, because their winding is consistent.
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel::importer {

struct InvertedPyramids {
    std::uint64_t count = 0;  // inverted pyramids; a cell may have several
    std::vector<Index> cells; // stored ids of their cells, sorted, distinct
};

[[nodiscard]] InvertedPyramids find_inverted_pyramids(const FaceMeshView& mesh);

} // namespace ciel::importer
