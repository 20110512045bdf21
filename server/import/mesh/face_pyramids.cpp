#include "import/mesh/face_pyramids.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>

namespace server::importer {

using ciel::operator-;

InvertedPyramids find_inverted_pyramids(const ciel::FaceMeshView& mesh) {
    // Smallest cosine of the angle between a face's outward normal and the direction from the cell's center to the
    // face's center. It is below 0, because the pyramids of collapsed cells are flat, but not inverted.
    constexpr double least_cosine = -1e-6;
    const std::vector<ciel::FaceShape> faces = ciel::face_shapes(mesh);
    const std::vector<ciel::Vec3d> centres = ciel::cell_centres(mesh, faces);
    InvertedPyramids inverted;
    const auto judge = [&](ciel::Index cell, const ciel::FaceShape& face, double sign) {
        const ciel::Vec3d arm = face.centre - centres[cell];
        const double longest = std::sqrt(ciel::dot(face.area, face.area) * ciel::dot(arm, arm));
        if (!(sign * ciel::dot(face.area, arm) < least_cosine * longest)) return;
        ++inverted.count;
        inverted.cells.push_back(cell);
    };
    for (ciel::Index face = 0; face < mesh.face_count(); ++face) {
        judge(mesh.owner[face], faces[face], 1.0);
        if (mesh.neighbour[face] != ciel::none) judge(mesh.neighbour[face], faces[face], -1.0);
    }
    std::sort(inverted.cells.begin(), inverted.cells.end());
    inverted.cells.erase(std::unique(inverted.cells.begin(), inverted.cells.end()), inverted.cells.end());
    return inverted;
}

} // namespace server::importer
