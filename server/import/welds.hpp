// Which points are one. By itself only the seam of a structured block closed onto itself (O- and C-grids) is welded;
// everything else only when asked, because faults and baffles must stay open.
#pragma once

#include "import/joined_mesh.hpp"
#include "import/options.hpp"
#include "import/pieces.hpp"

namespace ciel::importer {

struct Seam { // of one structured block
    std::size_t part = 0;
    PointPairs points;
    double tolerance = 0; // how far apart the two points of a pair may be
};

struct Welds {
    std::vector<Index> representative; // running point -> the point it becomes; empty when nothing is welded
    std::uint64_t welded_points = 0;
    std::vector<Seam> seams; // those that were welded
    std::vector<std::string> notes;
};

// `cut` is joined whatever the mode.
[[nodiscard]] Welds find_welds(const JoinedMesh& mesh, Weld mode, const Cut& cut);

// What the two sides of a seam differ in at this time: the name of a point field, or "position". Empty when they agree.
[[nodiscard]] std::string difference_across(const std::vector<Seam>& seams, const std::vector<JoinedMesh::Part>& parts);

} // namespace ciel::importer
