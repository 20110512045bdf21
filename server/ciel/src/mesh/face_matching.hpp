// Pairs faces that are the two sides of one face (paper, appendix A: the counterpart in the adjacent polyhedron).
#pragma once

#include "ciel/assemble.hpp"

namespace ciel {

struct CellOfFace {
    std::span<Index> cell;          // input face -> input cell, none for faces of cells that are left out, as matching
                                    // leaves cells out that have the same faces as an earlier one
    std::span<const double> volume; // input cell -> volume, not negative
    std::span<std::uint8_t> turn;   // input face -> reversed when stored; matching may turn whole cells
};

struct MatchedFaces {
    std::vector<Index> partner;        // input face -> input face on the other side, none on the boundary
    std::vector<Index> repeated_cells; // ascending: left out, they have the faces of an earlier cell
    std::vector<Index> inverted_cells; // cells that were turned inside out to agree with their neighbours
    std::uint64_t internal_boundaries = 0;
};

// Linear in the input: faces meet in the list of their smallest vertex. On return the two sides of every match are
// wound against each other.
[[nodiscard]] MatchedFaces match_faces(const PolyhedraView& input, CellOfFace faces);

} // namespace ciel
