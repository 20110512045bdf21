// Matches the surfaces of the input to boundary faces of the mesh. If a surface has the same vtkPoints object as
// a volume, matches by point ids. Otherwise matches by the coordinates of the corners.
#pragma once

#include "import/mesh/joined_mesh.hpp"

namespace server::importer {

struct Patch {
    std::string name;
    std::size_t surface = 0;        // surface with the patch's values: index into InputGrids::surfaces, or none_of_them
    std::vector<ciel::Index> faces; // ids of boundary faces (StepMesh::boundary)
    std::vector<std::size_t> cells; // per face: the matching cell of the surface
    std::uint64_t unmatched = 0;    // number of cells of the surface that match no boundary face
    static constexpr std::size_t none_of_them = ~std::size_t{0};
};

// Corners are compared after welding. A surface gets each face at most once. `representative`: Welds::representative.
// `boundary`: as StepMesh::boundary. `point_of_vertex`: stored vertex -> running point.
[[nodiscard]] std::vector<Patch> match_patches(const ciel::FaceMeshView& boundary,
                                               std::span<const ciel::Index> point_of_vertex, const JoinedMesh& joined,
                                               const std::vector<ciel::Index>& representative,
                                               const std::vector<InputGrid>& surfaces);

} // namespace server::importer
