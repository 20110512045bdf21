#include "ciel/cell_geometry.hpp"

#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"

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

std::vector<FaceShape> face_shapes(const FaceMeshView& mesh) {
    std::vector<FaceShape> faces(mesh.face_count());
    parallel_for(faces.size(), grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> loop;
        for (std::size_t face = begin; face < end; ++face) {
            read_loop(mesh, static_cast<Index>(face), loop);
            faces[face] = face_shape(mesh, loop);
        }
    });
    return faces;
}

std::vector<Vec3d> cell_centres(const FaceMeshView& mesh, const std::vector<FaceShape>& faces) {
    const std::size_t cells = mesh.cell_count();
    const auto for_each_side = [&](auto&& visit) {
        for (Index face = 0; face < mesh.face_count(); ++face) {
            const FaceCells beside = read_cells(mesh, face);
            visit(beside.owner, faces[face], 1.0);
            if (beside.neighbour != none) visit(beside.neighbour, faces[face], -1.0);
        }
    };
    std::vector<Vec3d> guess(cells);
    std::vector<double> count(cells);
    for_each_side([&](Index cell, const FaceShape& face, double) {
        guess[cell] = guess[cell] + face.centre;
        ++count[cell];
    });
    for (std::size_t cell = 0; cell < cells; ++cell) guess[cell] = (1 / std::max(count[cell], 1.0)) * guess[cell];

    // The new center is the mean of the centroids of the pyramids from the guess to each face, weighted by volume.
    std::vector<Vec3d> moment(cells);
    std::vector<double> volume(cells);
    for_each_side([&](Index cell, const FaceShape& face, double sign) {
        const double part = std::max(0.0, sign * dot(face.area, face.centre - guess[cell]) / 3);
        volume[cell] += part;
        moment[cell] = moment[cell] + part * (0.75 * face.centre + 0.25 * guess[cell]);
    });
    for (std::size_t cell = 0; cell < cells; ++cell)
        if (volume[cell] > 0) guess[cell] = (1 / volume[cell]) * moment[cell];
    return guess;
}

} // namespace ciel
