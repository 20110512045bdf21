// Checksums of the mesh of a step. A step with the same checksum `cells` as the previous step reuses the mesh of that
// step.
#pragma once

#include "import/source/input_grids.hpp"

namespace server::importer {

struct Fingerprint {
    std::string cells;     // checksum of connectivity, blanking, and the names of volumes, surfaces and zones
    std::string positions; // checksum of the positions of the volumes' points

    [[nodiscard]] std::string text() const { return cells + ' ' + positions; }
};

[[nodiscard]] Fingerprint fingerprint(const InputGrids& input_grids);

} // namespace server::importer
