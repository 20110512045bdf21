// Faces of a mesh chosen by cell, by id or by vertex, and their size. Not in the paper. All functions: any thread; the
// results own their data; throw Error when an index leads out of the mesh.
#pragma once

#include "ciel/threshold_surface.hpp"

namespace ciel {

// `kept`, here and below: one flag per cell, or empty for all cells.

// Returns the boundary faces of the mesh, in the order of faces.
[[nodiscard]] std::vector<CellFace> boundary_faces(const FaceMeshView& mesh);

// Returns the faces with these ids whose owner is kept, each once and in the order of faces. `ids`: in any order.
[[nodiscard]] std::vector<CellFace> faces_by_id(const FaceMeshView& mesh, std::vector<Index> ids,
                                                std::span<const std::uint8_t> kept = {});

// Returns the boundary faces that lie in the level set of `level`: the value of each of their vertices differs from
// `level` by at most `tolerance`. The field is on the mesh's vertices.
[[nodiscard]] std::vector<CellFace> boundary_faces_at(const FaceMeshView& mesh, const Field& field, double level,
                                                      double tolerance);

// Returns the first of the faces `ids` that has all of these vertices, or `none`.
[[nodiscard]] Index face_with_vertices(const FaceMeshView& mesh, std::span<const Index> ids,
                                       std::span<const Index> vertices);

// Returns the vertices of all kept cells in ascending order, as points without polygons. points: positions of the
// topology's vertices. Reads the blocks that have kept cells; none if `kept` is empty. Uses all threads of the parallel
// loop.
[[nodiscard]] Surface vertices_of_cells(const Topology& topology, const FaceMeshView& points,
                                        std::span<const std::uint8_t> kept);

// Returns the vertices of a cell in ascending order. Reads its block.
[[nodiscard]] std::vector<Index> corners_of_cell(const Topology& topology, Index cell);

// Returns whether two meshes have the same number of vertices and the same cells. Two cells are the same if their faces
// have the same vertices in the same direction; the order of the faces and the first corner of each may differ. Reads
// all blocks of both meshes. Uses all threads of the parallel loop.
[[nodiscard]] bool same_cells(const Topology& a, const Topology& b);

struct FacesSize {
    Vec3d low{}, high{}; // corners of the bounding box, in the mesh's coordinates; infinite if there are no faces
    double area = 0;     // sum of the faces' areas; a bent face counts with the length of its area vector
};
[[nodiscard]] FacesSize size_of_faces(const FaceMeshView& mesh, std::span<const Index> ids);

} // namespace ciel
