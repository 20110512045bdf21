// Finds the cut faces of a mesh that was read in pieces, for example from a PVTU. A cut face is a pair of coincident
// boundary faces of two pieces whose corners are the same points. Two points are the same if their GlobalNodeIds are
// equal. If the pieces have no GlobalNodeIds, two points are the same if their coordinates and values are equal. A
// crack within a piece stays open. A crack along a cut stays open if the values on its two sides differ.
#pragma once

#include "ciel/matched_cells.hpp"
#include "import/mesh/joined_mesh.hpp"

#include <utility>

namespace server::importer {

struct PieceJoins {
    PointPairs points;        // running points to join
    std::uint64_t faces = 0;  // number of joined pairs of faces
    std::uint64_t single = 0; // cut faces without a counterpart on another piece; set only for OpenFOAM
    std::uint64_t apart = 0;  // faces that coincide with a face of another piece but differ in ids or values
};

// `cells`: the cells of `joined`, matched before any points are joined.
[[nodiscard]] PieceJoins find_cut_between_pieces(const ciel::MatchedCells& cells, const JoinedMesh& joined);

// Returns whether the two points of each pair are the same at a later step too: their GlobalNodeIds are equal, or else
// their coordinates and values. `pieces`: the members of the mesh with the data of that step.
[[nodiscard]] bool still_the_same(const PointPairs& points, const std::vector<JoinedMesh::Member>& pieces);

} // namespace server::importer
