// Finds points to weld. By default only the seam of a structured block closed onto itself (O- and C-grids) is welded,
// because faults and baffles must stay open.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/mesh/pieces.hpp"

#include <functional>

namespace ciel::importer {

enum class Weld { seams, none, all }; // seams: by default; none: --no-weld; all: --weld

struct Seam { // of one structured block
    std::size_t part = 0;
    PointPairs points;
    double tolerance = 0; // allowed difference of a coordinate within a pair, in the mesh's length unit
};

// Returns what differs between the two sides of a seam: "position" or the name of a point field. Empty if the sides of
// all seams agree. Implemented in values/seam_difference.hpp.
using SeamDifference =
    std::function<std::string(const std::vector<Seam>& seams, const std::vector<JoinedMesh::Member>& parts)>;

struct Welds {
    std::vector<Index> representative; // running point -> the point it becomes; empty when nothing is welded
    std::uint64_t welded_points = 0;
    std::vector<Seam> seams; // welded seams only
    std::vector<std::string> notes;
};

// Joins the points of `cut` in every mode. Does not weld a seam for which `difference` is not empty.
[[nodiscard]] Welds find_welds(const JoinedMesh& mesh, Weld mode, const PieceJoins& cut,
                               const SeamDifference& difference);

} // namespace ciel::importer
