// Selects faces of a mesh by cell, by id or by vertex, and measures faces. Not in the paper. Any thread may call the
// functions. The results own their data. The functions throw Error when an index that they read from the mesh is out of
// range. REQUIRES: face ids from the caller exist, and `kept` has one flag for each cell or is empty.
#pragma once

#include "ciel/threshold_surface.hpp"

namespace ciel {

// In this file, an empty `kept` means that all cells are kept.

// Returns the boundary faces of the mesh, in the order of face ids.
[[nodiscard]] std::vector<CellFace> boundary_faces(const FaceMeshView& mesh);

// Returns the faces with these ids whose owner is kept, each once, in the order of face ids. `ids`: in any order.
[[nodiscard]] std::vector<CellFace> faces_by_id(const FaceMeshView& mesh, std::vector<Index> ids,
                                                std::span<const std::uint8_t> kept = {});

// Returns the boundary faces that lie in the level set of `level`: each vertex of such a face has a value that differs
// from `level` by at most `tolerance`, in units of the field. REQUIRES: `field` is on the vertices of `mesh`. Throws
// Error when a value cannot be read.
[[nodiscard]] std::vector<CellFace> boundary_faces_at(const FaceMeshView& mesh, const Field& field, double level,
                                                      double tolerance);

// Returns the first face in `ids` that has all of `vertices`, or `none`.
[[nodiscard]] Index face_with_vertices(const FaceMeshView& mesh, std::span<const Index> ids,
                                       std::span<const Index> vertices);

// Returns the vertices of all kept cells in ascending order, as a surface without polygons. `points`: the positions of
// the topology's vertices. Reads the blocks that have kept cells; reads no block if `kept` is empty. Throws Error when
// `points` or `kept` has a wrong size. Uses all threads of parallel_for.
[[nodiscard]] Surface vertices_of_cells(const Topology& topology, const FaceMeshView& points,
                                        std::span<const std::uint8_t> kept);

// Returns the vertices of a cell in ascending order. Reads the block of the cell. Throws Error when the cell does not
// exist.
[[nodiscard]] std::vector<Index> corners_of_cell(const Topology& topology, Index cell);

// Returns whether two meshes have the same number of vertices and the same cells. Two cells are the same if their faces
// have the same vertices in the same direction. The order of the faces and the first corner of each face may differ.
// Reads all blocks of both meshes. Uses all threads of parallel_for.
[[nodiscard]] bool same_cells(const Topology& a, const Topology& b);

struct FacesSize {
    // Corners of the bounding box, in the mesh's coordinates. If there are no faces, `low` is infinity and `high` is
    // minus infinity.
    Vec3d low{}, high{};
    // Sum of the areas of the faces. The area of a bent face is the length of its area vector.
    double area = 0;
};
// Returns the bounding box and the area of the faces `ids`.
[[nodiscard]] FacesSize size_of_faces(const FaceMeshView& mesh, std::span<const Index> ids);

} // namespace ciel
