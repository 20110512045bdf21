// A mesh that was read in pieces, as a PVTU is: the faces along which it was cut lie on each other in pairs, belong to
// two different pieces, and their corners are the same points: by the ids that the file gives them (GlobalNodeId), else
// by equal coordinates and values, to the bit. So a crack within a piece stays open, and one along a cut does where its
// sides differ.
#pragma once

#include "import/mesh/joined_mesh.hpp"

#include <utility>

namespace ciel::importer {

struct Cut {
    PointPairs points;        // to be one again
    std::uint64_t faces = 0;  // pairs of faces
    std::uint64_t single = 0; // faces of no surface that lie on no other
    std::uint64_t apart = 0;  // faces of different pieces that lie on another one, and whose points are not the same
};

// Between the parts of `joined` that are pieces of one whole; `pieces` is what it was assembled to.
[[nodiscard]] Cut find_cut_between_parts(const Assembled& pieces, const JoinedMesh& joined);

// Whether all pairs that a cut has joined are the same points at another time, too.
[[nodiscard]] bool still_the_same(const PointPairs& points, const std::vector<JoinedMesh::Member>& parts);

} // namespace ciel::importer
