// Numbered faces of a mesh: the boundary faces, and the faces inside the mesh that belong to a group, such as a baffle.
// Groups and boundary arrays refer to faces by these numbers. Not in the paper.
#pragma once

#include "ciel/topology.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

// A list of faces, in the arrays of a FaceMesh.
struct FaceLists {
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex, owner, neighbour;
};

// Returns the boundary faces in the order of their ids, and then the faces `inner`. The number of a face is its index
// in this list. It is also the index of the face's value in an array on boundary faces. `inner`: ids of faces between
// two cells. Reads all faces once. Throws Error when an index in the mesh is out of range.
[[nodiscard]] FaceLists numbered_faces(const FaceMeshView& mesh, std::span<const Index> inner);

// Returns the number of each face in `faces`, or `none` for a face between two cells. `faces`: face ids, in any order.
// Reads all faces once. Throws Error when an index in the mesh is out of range.
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

// Returns all faces of the mesh, sorted by owner. Takes the boundary faces from `boundary`, in their order, and the
// faces inside the mesh from the blocks. `boundary`: faces sorted by owner; faces between two cells are ignored. No
// collapsed face is lost, because assemble() makes every collapsed face a boundary face. Reads all blocks, and needs
// memory for all faces. Uses all threads of parallel_for. Throws Error when a record is damaged.
[[nodiscard]] FaceLists all_faces(const Topology& topology, const FaceMeshView& boundary);

// Returns a mesh with the positions and cells of `points` and other faces. The result keeps the arrays of both alive.
// Throws Error when `points` has no owner.
[[nodiscard]] FaceMeshView with_faces(FaceMeshView points, std::shared_ptr<const FaceLists> faces);

} // namespace ciel
