// How much each face of a patch says about its vertices: weights that are exact for fields linear along the patch.
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace ciel::importer {

struct PatchWeight {
    Index vertex = 0;     // stored
    std::size_t face = 0; // index into the patch's faces
    double weight = 0;    // of one vertex: sum 1
};

struct PatchVertex {
    Index vertex = 0;           // stored
    double area = 0;            // of the patch's faces around it; never 0
    std::vector<Vec3d> normals; // of these faces: orthogonal, of length 1, several where the patch has an edge there
};

struct PatchWeights {
    std::vector<PatchWeight> weights;
    std::vector<PatchVertex> vertices;
};

// `faces` of the mesh make the patch.
[[nodiscard]] PatchWeights weigh_patch(const FaceMeshView& mesh, const std::vector<Index>& faces);

} // namespace ciel::importer
