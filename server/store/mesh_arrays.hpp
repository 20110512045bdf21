// MeshArrays: the meshes of a dataset as arrays of positions and lists of faces. Only the kernel, the store, the
// programs that write datasets and the benchmarks read these arrays. Other code uses mesh_questions.hpp, LoadedDataset
// and ScalarField (tests/layering/check_includes.py).
#pragma once

#include "ciel/face_mesh.hpp"

namespace server::store {

// Each view owns its arrays (FaceMeshView::keep_alive). Thread-safe.
class MeshArrays {
public:
    virtual ~MeshArrays() = default;

    // Returns the mesh with all faces (all_faces in ciel/numbered_faces.hpp). They are kept in memory until the last
    // view of them is destroyed; in format 1 they are mapped. Throws Error that names a damaged file.
    [[nodiscard]] virtual ciel::FaceMeshView all_faces(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the mesh without faces: face_count() is 0. Reads only positions.
    [[nodiscard]] virtual ciel::FaceMeshView points(std::size_t mesh, std::size_t coordinates) const = 0;
    // Like points, but reads no position. Positions are read and checked when FaceMeshView::loader loads them. If the
    // mesh was stored without blocks, reads all positions.
    [[nodiscard]] virtual ciel::FaceMeshView points_to_load(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the mesh with the numbered faces: boundary faces, then inner faces of groups (ciel/numbered_faces.hpp).
    // Positions are as in points_to_load. The first call checks the faces. Group::ids of a group of faces are numbers
    // of these faces. Throws Error as all_faces does.
    [[nodiscard]] virtual ciel::FaceMeshView numbered_faces(std::size_t mesh, std::size_t coordinates) const = 0;
    // Like numbered_faces, but returns only the boundary faces, which are the first numbered faces.
    [[nodiscard]] virtual ciel::FaceMeshView boundary(std::size_t mesh, std::size_t coordinates) const = 0;
};

} // namespace server::store
