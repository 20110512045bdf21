// Checksums of the mesh of a step. A step with the same checksum `cells` as the previous step reuses its mesh.
#pragma once

#include "import/source/data_sets.hpp"

namespace ciel::importer {

struct Fingerprint {
    std::string cells;     // checksum of connectivity, blanking, and the names of blocks, surfaces and zones
    std::string positions; // checksum of the positions of the volumes' points
};

[[nodiscard]] Fingerprint fingerprint(const DataSets& data_sets);

} // namespace ciel::importer
