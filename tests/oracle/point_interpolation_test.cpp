#include "ciel/cell_shapes.hpp"
#include "ciel/point_interpolation.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

constexpr double allowed = 1e-4; // In cell edges. Positions and values are float32.

// For each axis, true when the vertex lies on one of the box's two sides across that axis.
std::array<bool, 3> at_sides(const FaceMeshView& mesh, Index vertex, const std::array<double, 3>& box) {
    std::array<bool, 3> at{};
    const Vec3d p = position(mesh, vertex);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = p[axis] + mesh.origin[axis];
        at[axis] = std::abs(x) < 1e-6 || std::abs(x - box[axis]) < 1e-6;
    }
    return at;
}

// Interpolates the coordinate `axis` of the cell centers to the vertices. Returns the largest difference from the
// vertices' own coordinate, without vertices on the sides across that axis.
double largest_error(const std::array<int, 3>& cubes, std::size_t axis) {
    const Assembled assembled = assemble(view(hexahedra({cubes, 0.15, 7})));
    const FaceMeshView mesh = assembled.mesh.view();
    const Topology topology(mesh);
    std::vector<float> cells;
    for (const Vec3d& center : cell_centers(topology, mesh)) cells.push_back(static_cast<float>(center[axis]));
    const std::vector<float> points = PointInterpolation(topology, mesh).apply(cells, 1);
    const std::array<double, 3> box{static_cast<double>(cubes[0]), static_cast<double>(cubes[1]),
                                    static_cast<double>(cubes[2])};
    double largest = 0;
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        if (!at_sides(mesh, vertex, box)[axis])
            largest = std::max(largest, std::abs(position(mesh, vertex)[axis] - static_cast<double>(points[vertex])));
    return largest;
}

TEST(point_interpolation, is_exact_for_linear_fields_inside_and_along_the_boundary) {
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_LT(largest_error({6, 5, 4}, axis), allowed) << axis;
}

TEST(point_interpolation, is_exact_within_one_layer_of_cells) {
    EXPECT_LT(largest_error({8, 7, 1}, 0), allowed);
    EXPECT_LT(largest_error({8, 7, 1}, 1), allowed);
    EXPECT_LT(largest_error({9, 1, 1}, 0), allowed);
}

TEST(point_interpolation, takes_the_only_cell_at_a_corner) {
    const Assembled assembled = assemble(view(hexahedra({{2, 2, 2}, 0, 1})));
    const FaceMeshView mesh = assembled.mesh.view();
    const Topology topology(mesh);
    std::vector<float> cells(8, 0);
    cells[3] = 5;
    const std::vector<float> points = PointInterpolation(topology, mesh).apply(cells, 1);
    EXPECT_EQ(std::count(points.begin(), points.end(), 5.0F), 1);
}

// The blocks have no faces that collapsed to a point.
TEST(point_interpolation, takes_a_cell_that_collapsed_to_a_point) {
    Polyhedra input = hexahedra({{2, 1, 1}});
    input.positions.insert(input.positions.end(), {9, 9, 9});
    const auto alone = static_cast<Index>(input.positions.size() / 3 - 1);
    for (std::size_t corner = input.face_offset[input.cell_offset[1]]; corner < input.face_vertex.size(); ++corner)
        input.face_vertex[corner] = alone;
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = assembled.mesh.view();
    ASSERT_EQ(mesh.cell_count(), 2U);
    const std::vector<float> cells{assembled.original_cell[0] == 1 ? 5.0F : 0.0F,
                                   assembled.original_cell[1] == 1 ? 5.0F : 0.0F};
    const std::vector<float> points = PointInterpolation(Topology(mesh), mesh).apply(cells, 1);
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        EXPECT_EQ(points[vertex], assembled.original_vertex[vertex] == alone ? 5.0F : 0.0F) << vertex;
}

} // namespace
} // namespace ciel::test
