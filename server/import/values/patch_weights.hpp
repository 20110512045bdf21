// Weights that interpolate from a patch's faces to its vertices, exact for fields that are linear along the patch.
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace ciel::importer {

struct PatchWeight {
    Index vertex = 0;     // stored id
    std::size_t face = 0; // index into the patch's faces
    double weight = 0;    // the weights of a vertex sum to 1
};

struct PatchVertex {
    Index vertex = 0;           // stored id
    double area = 0;            // sum over the patch's faces around the vertex; never 0
    std::vector<Vec3d> normals; // orthogonal unit normals of the faces around it; several at an edge
};

struct PatchWeights {
    std::vector<PatchWeight> weights;
    std::vector<PatchVertex> vertices;
};

// `faces`: stored ids of the patch's faces.
[[nodiscard]] PatchWeights weigh_patch(const FaceMeshView& mesh, const std::vector<Index>& faces);

} // namespace ciel::importer
