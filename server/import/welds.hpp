// Which points are one. By itself only the seam of a structured block closed onto itself (O- and C-grids) is welded;
// everything else only when asked, because faults and baffles must stay open.
#pragma once

#include "import/joined_mesh.hpp"
#include "import/options.hpp"

namespace ciel::importer {

struct Welds {
    std::vector<Index> representative; // running point -> the point it becomes; empty when nothing is welded
    std::uint64_t welded_points = 0;
    std::vector<std::string> notes;
};

[[nodiscard]] Welds find_welds(const JoinedMesh& mesh, Weld mode);

} // namespace ciel::importer
