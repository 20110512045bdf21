#include "import/mesh/face_pyramids.hpp"

#include "ciel/cell_shapes.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace server::importer {

using ciel::operator-;

InvertedPyramids find_inverted_pyramids(const ciel::MatchedCells& mesh, const ciel::FaceMeshView& points) {
    // Smallest cosine of the angle between a face's outward normal and the direction from the cell's center to the
    // face's center. It is below 0, because the pyramids of collapsed cells are flat, but not inverted.
    constexpr double least_cosine = -1e-6;
    InvertedPyramids inverted;
    std::mutex mutex;
    ciel::for_cell_shapes(
        mesh, points, [&](ciel::Index cell, std::span<const ciel::FaceShape> faces, const ciel::Vec3d& center) {
            for (const ciel::FaceShape& face : faces) {
                const ciel::Vec3d arm = face.center - center;
                const double longest = std::sqrt(ciel::dot(face.area, face.area) * ciel::dot(arm, arm));
                if (!(ciel::dot(face.area, arm) < least_cosine * longest)) continue;
                const std::scoped_lock lock(mutex);
                ++inverted.count;
                inverted.cells.push_back(cell);
            }
        });
    std::sort(inverted.cells.begin(), inverted.cells.end());
    inverted.cells.erase(std::unique(inverted.cells.begin(), inverted.cells.end()), inverted.cells.end());
    return inverted;
}

} // namespace server::importer
