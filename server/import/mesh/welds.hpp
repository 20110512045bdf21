// Finds points to weld. By default, welds only the cuts between pieces and the seam of a structured grid that closes
// onto itself (O-grids and C-grids). Other coincident points stay apart, because faults and baffles must stay open.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/mesh/pieces.hpp"

#include <functional>

namespace server::importer {

enum class Weld { seams, none, all }; // seams: the default; none: --no-weld; all: --weld

struct Seam { // coincident points of one structured grid that closes onto itself
    std::size_t member = 0;
    PointPairs points;
    double tolerance = 0; // largest difference of a coordinate in a pair, in the mesh's length unit
};

// Returns the name of a quantity that differs between the two sides of a seam: "position" or the name of a point field.
// Returns an empty string if the sides of all seams agree. Implemented in values/seam_difference.hpp.
using SeamDifference =
    std::function<std::string(const std::vector<Seam>& seams, const std::vector<JoinedMesh::Member>& members)>;

struct Welds {
    std::vector<ciel::Index>
        representative; // running point -> running point that replaces it; empty if nothing is welded
    std::uint64_t welded_points = 0;
    std::vector<Seam> seams; // welded seams only
    std::vector<std::string> notes;
};

// Joins the points of `cut` in every mode. A seam stays open if a quantity differs between its two sides; `difference`
// then returns the name of this quantity.
[[nodiscard]] Welds find_welds(const JoinedMesh& mesh, Weld mode, const PieceJoins& cut,
                               const SeamDifference& difference);

} // namespace server::importer
