// Which points are one. By itself only the seam of a structured block closed onto itself (O- and C-grids) is welded;
// everything else only when asked, because faults and baffles must stay open.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/mesh/pieces.hpp"

#include <functional>

namespace ciel::importer {

enum class Weld { seams, none, all }; // seams: opposite faces of one structured block

struct Seam { // of one structured block
    std::size_t part = 0;
    PointPairs points;
    double tolerance = 0; // how far apart the two points of a pair may be
};

// What the two sides of seams differ in: the name of a point field, or "position". Empty when they agree.
// (values/seam_difference.hpp)
using SeamDifference =
    std::function<std::string(const std::vector<Seam>& seams, const std::vector<JoinedMesh::Member>& parts)>;

struct Welds {
    std::vector<Index> representative; // running point -> the point it becomes; empty when nothing is welded
    std::uint64_t welded_points = 0;
    std::vector<Seam> seams; // those that were welded
    std::vector<std::string> notes;
};

// `cut` is joined whatever the mode. A seam whose sides differ is not welded.
[[nodiscard]] Welds find_welds(const JoinedMesh& mesh, Weld mode, const Cut& cut, const SeamDifference& difference);

} // namespace ciel::importer
