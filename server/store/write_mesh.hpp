// Writes the directory of one mesh of a dataset.
#pragma once

#include "ciel/topology.hpp"
#include "store/format/attributes.hpp"
#include "store/format/zarr_array.hpp"
#include "store/writer.hpp"

namespace server::store {

struct NewMesh {
    const ciel::FaceMesh& mesh;      // with all faces; with the boundary faces if `cells` is set
    const ciel::MatchedCells* cells; // the blocks are built from these cells; null: from the faces of `mesh`
};
struct OriginalIds {
    std::span<const ciel::Index> vertex, cell;
};

// The caller must write the returned attributes, and the .zarray of the positions. Throws Error when an array has a
// wrong size, when a group has an id out of range, or when a coordinate is not finite.
[[nodiscard]] MeshAttributes write_mesh(const std::filesystem::path& directory, const NewMesh& mesh,
                                        const OriginalIds& original, std::span<const NamedGroup> groups,
                                        const SolverIds& solver, const std::string& dataset_id);

// `directory`: the directory of the mesh.
void write_boxes(const std::filesystem::path& directory, const ciel::Topology& topology, const std::string& dataset_id,
                 std::size_t coordinates, ciel::ValuesView positions);

void check_finite(ciel::ValuesView positions); // throws Error if a coordinate is not finite

// Return the shape, the chunks and the type of a mesh's positions, which have `sets` coordinate sets, and of an array
// with `steps` steps of `items` vertices, cells or boundary faces.
[[nodiscard]] ZarrArray positions_shape(std::uint64_t sets, const MeshInfo& mesh);
[[nodiscard]] ZarrArray values_shape(std::uint64_t steps, std::uint64_t items, const ArrayInfo& of);

} // namespace server::store
