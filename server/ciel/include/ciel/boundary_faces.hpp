// The boundary faces of a mesh, numbered consecutively in the order of their face ids. Not in the paper.
#pragma once

#include "ciel/face_mesh.hpp"

#include <span>
#include <vector>

namespace ciel {

// The boundary faces alone. The number of one is its place here, and that of its value in an array on boundary faces.
struct BoundaryFaces {
    FaceMeshView mesh; // with the boundary faces only, all without neighbour; its vertices and cells are those of all
    Ids face;          // by number: the id of the face in the whole mesh; ascending
};

// Owns them.
struct BoundaryFaceLists {
    std::vector<std::uint64_t> face_offset{0}; // by number, like that of a FaceMesh
    std::vector<Index> face_vertex, owner;
    std::vector<Index> face; // as in BoundaryFaces
};

// Reads all faces of the mesh once. Throws Error when the mesh holds an index that is out of range.
[[nodiscard]] BoundaryFaceLists boundary_face_lists(const FaceMeshView& mesh);

// Return for each of `faces` its number, or `none` for a face between two cells. `faces` may be in any order. The
// second one reads all faces of the mesh once. Throw Error when the mesh holds an index that is out of range.
[[nodiscard]] std::vector<Index> boundary_numbers(const BoundaryFaces& boundary, std::span<const Index> faces);
[[nodiscard]] std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces);

} // namespace ciel
