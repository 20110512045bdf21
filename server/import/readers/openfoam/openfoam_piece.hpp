// Reads and checks the mesh files of one piece of an OpenFOAM case: the whole case, or one processor's share of a
// region.
#pragma once

#include "import/parsers/openfoam/poly_mesh.hpp"
#include "import/readers/openfoam/openfoam_case.hpp"

namespace server::importer {

struct FoamPieceFiles {
    std::vector<double> points;                 // x, y, z of each point
    FoamFaces faces;                            // with valid point ids
    std::vector<std::int64_t> owner, neighbour; // valid cell ids, one per face; `neighbour` has only the inner faces
    std::vector<FoamPatch> patches;             // each patch has only boundary faces
    std::vector<FoamZone> cell_zones, face_zones;
    std::vector<std::int64_t> cell_addressing; // cell -> cell before decomposition; empty if the file is not readable
    std::size_t cell_count = 0;
    std::vector<std::string> lost; // sentences on optional files that could not be read

    [[nodiscard]] std::size_t face_count() const { return owner.size(); }
};

// Throws Error naming the file if a required file is missing or damaged.
[[nodiscard]] FoamPieceFiles read_foam_piece(const FoamRoot& root, const std::string& region, double time);

} // namespace server::importer
