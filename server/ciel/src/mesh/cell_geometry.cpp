#include "ciel/cell_geometry.hpp"

#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"
#include "mesh/cell_faces.hpp"

#include <algorithm>

namespace ciel {

namespace {

constexpr std::size_t grain = 4096;

} // namespace

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
    for_each_triangle([&](Vec3d area, Vec3d centre) {
        const double share = dot(area, shape.area);
        total += share;
        shape.centre = shape.centre + share * centre;
    });
    shape.centre = total > 0 ? (1 / total) * shape.centre : mean;
    return shape;
}

void read_loop(const FaceMeshView& mesh, Index face, std::vector<Index>& loop) {
    const Ids stored = mesh.loop(face);
    loop.assign(stored.begin(), stored.end());
}

FaceCells read_cells(const FaceMeshView& mesh, Index face) { return {mesh.owner[face], mesh.neighbour[face]}; }

namespace {

// `faces`: of one cell. The areas point out of the cell.
Vec3d centroid(std::span<const FaceShape> faces) {
    Vec3d guess{};
    for (const FaceShape& face : faces) guess = guess + face.centre;
    guess = (1 / std::max(static_cast<double>(faces.size()), 1.0)) * guess;

    // The mean of the centroids of the pyramids from the guess to each face, weighted by volume.
    Vec3d moment{};
    double volume = 0;
    for (const FaceShape& face : faces) {
        const double part = std::max(0.0, dot(face.area, face.centre - guess) / 3);
        volume += part;
        moment = moment + part * (0.75 * face.centre + 0.25 * guess);
    }
    return volume > 0 ? (1 / volume) * moment : guess;
}

} // namespace

void for_cell_shapes(const FaceMeshView& mesh, const OnCell& visit) {
    const detail::CellFaces faces = detail::cell_faces(mesh);
    parallel_for(mesh.cell_count(), grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> loop;
        std::vector<FaceShape> shapes;
        for (auto cell = static_cast<Index>(begin); cell < end; ++cell) {
            shapes.clear();
            faces.for_faces(cell, [&](Index face) {
                read_loop(mesh, face, loop);
                FaceShape shape = face_shape(mesh, loop);
                if (face < faces.own_begin[cell]) shape.area = -1.0 * shape.area;
                shapes.push_back(shape);
            });
            visit(cell, shapes, centroid(shapes));
        }
    });
}

std::vector<Vec3d> cell_centres(const FaceMeshView& mesh) {
    std::vector<Vec3d> centres(mesh.cell_count());
    for_cell_shapes(mesh, [&](Index cell, std::span<const FaceShape>, const Vec3d& centre) { centres[cell] = centre; });
    return centres;
}

} // namespace ciel
