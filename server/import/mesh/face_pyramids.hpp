// Cells with a face that looks inwards: seen from the cell's centre the pyramid over it is inside out. The winding is
// consistent all the same, so they are kept.
#pragma once

#include "ciel/face_mesh.hpp"

namespace ciel::importer {

struct InvertedPyramids {
    std::uint64_t count = 0;
    std::vector<Index> cells; // stored ids, sorted
};

[[nodiscard]] InvertedPyramids find_inverted_pyramids(const FaceMeshView& mesh);

} // namespace ciel::importer
