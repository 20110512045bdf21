// Finds the cut faces of a mesh that was read in pieces, such as a PVTU: coincident boundary faces of two pieces whose
// corners are the same points. Points are the same by GlobalNodeId, else by equal coordinates and values. A crack
// within a piece stays open, and so does a crack along a cut if the values on its sides differ.
#pragma once

#include "import/mesh/joined_mesh.hpp"

#include <utility>

namespace ciel::importer {

struct PieceJoins {
    PointPairs points;        // running points to join
    std::uint64_t faces = 0;  // joined pairs of faces
    std::uint64_t single = 0; // cut faces without a counterpart; only OpenFOAM's reader reports them
    std::uint64_t apart = 0;  // faces that coincide with a face of another piece but have other ids or values
};

// Compares the boundary faces of parts with the same `whole`. `pieces`: `joined`, assembled before joining.
[[nodiscard]] PieceJoins find_cut_between_parts(const Assembled& pieces, const JoinedMesh& joined);

// Returns whether the points of all joined pairs are also the same in `parts`, which have the data of a later step.
[[nodiscard]] bool still_the_same(const PointPairs& points, const std::vector<JoinedMesh::Member>& parts);

} // namespace ciel::importer
