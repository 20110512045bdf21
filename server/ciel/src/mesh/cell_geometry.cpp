#include "ciel/cell_geometry.hpp"

#include "ciel/vector_operators.hpp"

namespace ciel {

// The center is the mean of the centroids of fan triangles, weighted by the triangle areas along the face normal.
FaceShape face_shape(const FaceMeshView& mesh, std::span<const Index> loop) {
    Vec3d mean{};
    for (const Index vertex : loop) mean = mean + position(mesh, vertex);
    mean = (1.0 / static_cast<double>(loop.size())) * mean;

    const auto for_each_triangle = [&](auto&& visit) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3d a = position(mesh, loop[i]);
            const Vec3d b = position(mesh, loop[(i + 1) % loop.size()]);
            visit(0.5 * cross(a - mean, b - mean), (1.0 / 3) * (a + b + mean));
        }
    };
    FaceShape shape;
    for_each_triangle([&](Vec3d area, Vec3d) { shape.area = shape.area + area; });
    double total = 0;
    for_each_triangle([&](Vec3d area, Vec3d center) {
        const double share = dot(area, shape.area);
        total += share;
        shape.center = shape.center + share * center;
    });
    shape.center = total > 0 ? (1 / total) * shape.center : mean;
    return shape;
}

void read_loop(const FaceMeshView& mesh, Index face, std::vector<Index>& loop) {
    const Ids stored = mesh.loop(face);
    loop.assign(stored.begin(), stored.end());
}

FaceCells read_cells(const FaceMeshView& mesh, Index face) { return {mesh.owner[face], mesh.neighbour[face]}; }

} // namespace ciel
