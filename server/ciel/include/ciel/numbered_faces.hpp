// The faces of a mesh that have numbers: those of the boundary, and those inside the mesh that a group has, such as a
// baffle. Not in the paper.
#pragma once

#include "ciel/topology.hpp"

#include <span>
#include <vector>

namespace ciel {

// Faces of a mesh, with the arrays of a FaceMesh.
struct FaceLists {
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex, owner, neighbour;
};

// Returns the boundary faces in the order of their ids, and then the faces `inner`. The number of a face is its place
// in this list. The number of a boundary face is also the place of its value in an array on boundary faces. inner: ids
// of faces between two cells. Reads all faces once. Throws Error when the mesh holds an index that is out of range.
[[nodiscard]] FaceLists numbered_faces(const FaceMeshView& mesh, std::span<const Index> inner);

// Returns for each of `faces` (ids, in any order) its number, or `none` for a face between two cells. Reads all faces
// once. Throws Error when the mesh holds an index that is out of range.
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

// Returns all faces of the mesh in the order of their owners. Takes the boundary faces from `boundary`, in their order,
// and the faces inside the mesh from the blocks. Collapsed faces are always boundary faces (assemble). boundary: faces
// in the order of their owners; those between two cells are ignored. Reads all blocks, and needs memory for all faces.
// Uses all threads of the parallel loop. Throws Error when a record is damaged.
[[nodiscard]] FaceLists all_faces(const Topology& topology, const FaceMeshView& boundary);

// Returns a mesh of the positions and cells of `points` with other faces. `faces` must outlive the result.
[[nodiscard]] FaceMeshView with_faces(FaceMeshView points, const FaceLists& faces);

} // namespace ciel
