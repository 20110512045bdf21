// Named boundary faces: the surface blocks of the input found again on the mesh, by the ids of their corners where they
// share the points of a volume block, else by the coordinates.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace ciel::importer {

struct Patch {
    std::string name;
    std::size_t surface = 0;        // whose values it has: index into DataSets::surfaces, or none_of_them
    std::vector<Index> faces;       // stored boundary faces...
    std::vector<std::size_t> cells; // ...and for each the cell of the surface it is
    std::uint64_t unmatched = 0;    // cells of the surface that are no boundary face of the mesh
    static constexpr std::size_t none_of_them = ~std::size_t{0};
};

// A cell matches a boundary face that has the same corners (welded or not). A surface claims each face once.
// `representative`: as Welds has it.
[[nodiscard]] std::vector<Patch> match_patches(const Assembled& assembled, const JoinedMesh& joined,
                                               const std::vector<Index>& representative,
                                               const std::vector<DataSet>& surfaces);

} // namespace ciel::importer
