#include "ciel/cell_shapes.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"
#include "mesh/matched_cells.hpp"

#include <algorithm>

namespace ciel {

namespace {

constexpr std::size_t grain = 4096;

// Returns the centroid of a cell. `faces`: the faces of the cell, with areas that point out of the cell.
Vec3d centroid(std::span<const FaceShape> faces) {
    Vec3d guess{};
    for (const FaceShape& face : faces) guess = guess + face.center;
    guess = (1 / std::max(static_cast<double>(faces.size()), 1.0)) * guess;

    // The mean of the centroids of the pyramids from the guess to each face, weighted by volume.
    Vec3d moment{};
    double volume = 0;
    for (const FaceShape& face : faces) {
        const double part = std::max(0.0, dot(face.area, face.center - guess) / 3);
        volume += part;
        moment = moment + part * (0.75 * face.center + 0.25 * guess);
    }
    return volume > 0 ? (1 / volume) * moment : guess;
}

void check_points(const FaceMeshView& points, std::size_t vertices) {
    if (points.vertex_count() != vertices)
        fail("the positions belong to another mesh than the cells; pass those of the same mesh");
}

} // namespace

void for_cell_shapes(const MatchedCells& cells, const FaceMeshView& points, const OnCell& visit) {
    const MatchedCells::Data& data = cells.data();
    check_points(points, data.original_vertex.size());
    parallel_for(data.cell_count(), grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> loop;
        std::vector<FaceShape> shapes;
        for (auto cell = static_cast<Index>(begin); cell < end; ++cell) {
            shapes.clear();
            data.for_faces(cell, [&](Index face, Index) {
                loop.clear();
                data.append_loop(cell, face, loop);
                shapes.push_back(face_shape(points, loop));
            });
            visit(cell, shapes, centroid(shapes));
        }
    });
}

void for_cell_shapes(const Topology& topology, const FaceMeshView& points, const OnCell& visit) {
    check_points(points, topology.counts().vertices);
    const Topology::Blocks& blocks = topology.blocks();
    parallel_for(blocks.count(), 1, [&](std::size_t begin, std::size_t end) {
        detail::CellLoops loops;
        std::vector<FaceShape> shapes;
        for (auto b = static_cast<Index>(begin); b < end; ++b)
            detail::for_cells(blocks.cells(b), loops, [&](Index cell, const detail::CellLoops& of_cell) {
                shapes.clear();
                for (std::size_t face = 0; face < of_cell.count(); ++face)
                    shapes.push_back(face_shape(points, of_cell.face(face)));
                visit(cell, shapes, centroid(shapes));
            });
    });
}

std::vector<Vec3d> cell_centers(const Topology& topology, const FaceMeshView& points) {
    std::vector<Vec3d> centers(topology.counts().cells);
    for_cell_shapes(topology, points,
                    [&](Index cell, std::span<const FaceShape>, const Vec3d& center) { centers[cell] = center; });
    return centers;
}

} // namespace ciel
