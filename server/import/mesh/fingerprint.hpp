// Tells whether a step has the mesh of the step before, without building it.
#pragma once

#include "import/source/data_sets.hpp"

namespace ciel::importer {

struct Fingerprint {
    std::string cells;     // everything but positions: connectivity, blanking, names of blocks and surfaces
    std::string positions; // of volumes
};

[[nodiscard]] Fingerprint fingerprint(const DataSets& data_sets);

} // namespace ciel::importer
