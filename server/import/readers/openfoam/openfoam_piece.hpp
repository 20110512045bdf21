// What one part of an OpenFOAM case says about its mesh, read and checked.
#pragma once

#include "import/parsers/openfoam/poly_mesh.hpp"
#include "import/readers/openfoam/openfoam_case.hpp"

namespace ciel::importer {

struct FoamPieceFiles {
    std::vector<double> points;                 // x, y, z of each
    FoamFaces faces;                            // every point is below the number of points
    std::vector<std::int64_t> owner, neighbour; // all cells are below cell_count; `neighbour` of the inner faces alone
    std::vector<FoamPatch> patches;             // within the faces beyond the inner ones
    std::vector<FoamZone> cell_zones, face_zones;
    std::vector<std::int64_t> cell_addressing; // cell -> cell of the whole case; empty where the files do not say
    std::size_t cell_count = 0;
    std::vector<std::string> lost; // sentences on what could not be read and is not needed

    [[nodiscard]] std::size_t face_count() const { return owner.size(); }
};

// Throws Error naming the file that the mesh cannot do without.
[[nodiscard]] FoamPieceFiles read_foam_piece(const FoamPart& part, const std::string& region, double time);

} // namespace ciel::importer
