// Matches each face of a cell with the equal face of the adjacent cell (paper, appendix A: the counterpart).
#pragma once

#include "mesh/input_faces.hpp"

namespace ciel::detail {

struct JudgedCells {
    std::span<std::uint8_t> left_out; // input cell -> 1 if it is left out; match_faces also sets it for repeated cells
    std::span<const double> volume;   // input cell -> its volume, >= 0
    std::span<std::uint8_t> turn;     // input face -> 1 if reversed when stored; match_faces may change it
};

struct MatchedFaces {
    std::vector<Index> partner;        // input face -> equal face of the adjacent cell; none on the boundary
    std::vector<Index> repeated_cells; // ascending; left out because an earlier cell has the same faces
    std::vector<Index> inverted_cells; // ascending; wound inwards, so that they agree with adjacent cells
    std::uint64_t internal_boundaries = 0;
};

// Takes linear time: a face is compared only with faces that have the same smallest vertex. Sets `turn` so that the
// loops of two matched faces have opposite directions after the marked faces are reversed.
[[nodiscard]] MatchedFaces match_faces(const InputFaces& input, JudgedCells cells);

} // namespace ciel::detail
