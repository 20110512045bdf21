// A mesh that was read in pieces (a decomposed OpenFOAM case): the faces along which it was cut belong to no surface of
// the input and lie on each other in pairs.
#pragma once

#include "import/patches.hpp"

#include <utility>

namespace ciel::importer {

using PointPairs = std::vector<std::pair<Index, Index>>; // running points

struct Cut {
    PointPairs points;        // to be one again
    std::uint64_t faces = 0;  // pairs of faces
    std::uint64_t single = 0; // faces of no surface that lie on no other
};

// `patches` are those of `pieces`.
[[nodiscard]] Cut find_cut(const Assembled& pieces, const std::vector<Patch>& patches);

} // namespace ciel::importer
