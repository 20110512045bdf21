// Weights for the interpolation from the faces of a patch to the vertices of the patch. The interpolation is exact for
// fields that are linear along the patch.
#pragma once

#include "ciel/face_mesh.hpp"

#include <vector>

namespace server::importer {

struct PatchWeight {
    ciel::Index vertex = 0; // vertex id in the mesh
    std::size_t face = 0;   // index into the patch's faces
    double weight = 0;      // the weights of a vertex sum to 1
};

struct PatchVertex {
    ciel::Index vertex = 0;           // vertex id in the mesh
    double area = 0;                  // sum of the areas of the patch's faces around the vertex; never 0
    std::vector<ciel::Vec3d> normals; // orthogonal unit normals of these faces; several where the patch has an edge
};

struct PatchWeights {
    std::vector<PatchWeight> weights;
    std::vector<PatchVertex> vertices;
};

// `faces`: ids of the patch's faces in `mesh`.
[[nodiscard]] PatchWeights weigh_patch(const ciel::FaceMeshView& mesh, const std::vector<ciel::Index>& faces);

} // namespace server::importer
