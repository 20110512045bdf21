// Positions as doubles: meshes whose coordinates floats cannot hold are cut as exactly as meshes near the origin.
#include "ciel/cell_locator.hpp"
#include "ciel/clip_surface.hpp"
#include "ciel/mesh_faces.hpp"
#include "ciel/sweep_sinks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace ciel::test {
namespace {

// A mesh whose points are doubles. `input` gives the cells.
struct DoubleMesh {
    DoubleMesh(const Polyhedra& input, const std::vector<double>& points, const Vec3d& surface_origin)
        : assembled(assemble(with_points(input, points))), topology(assembled.mesh.view(), {16}),
          origin(surface_origin) {}

    static PolyhedraView with_points(const Polyhedra& input, const std::vector<double>& points) {
        PolyhedraView cells = view(input);
        cells.origin = {};
        cells.positions = points;
        return cells;
    }
    [[nodiscard]] FaceMeshView mesh() const {
        FaceMeshView mesh = kept(assembled.mesh.view());
        mesh.surface_origin = origin;
        return mesh;
    }
    [[nodiscard]] std::vector<float> stored(std::span<const float> values) const {
        std::vector<float> out;
        for (const Index v : assembled.original_vertex) out.push_back(values[v]);
        return out;
    }
    // Returns the position of a surface's point without rounding it to a float.
    [[nodiscard]] Vec3d place(const EdgePoint& point) const {
        Vec3d at;
        for (std::size_t axis = 0; axis < 3; ++axis)
            at[axis] = lerp(mesh().positions[3 * std::size_t{point.a} + axis],
                            mesh().positions[3 * std::size_t{point.b} + axis], point.t);
        return at;
    }

    Assembled assembled;
    Topology topology;
    Vec3d origin;
};

// Coordinates of a survey in metres. Floats are half a metre apart there.
constexpr Vec3d survey{500000, 4500000, -2500};

// Rounds the positions to multiples of 2^-20, so that their sums with `survey` are exact.
std::vector<double> points_of(const Polyhedra& input, const Vec3d& shift) {
    std::vector<double> points;
    for (Id v = 0; v < input.vertex_count(); ++v)
        for (std::size_t axis = 0; axis < 3; ++axis)
            points.push_back(std::round(input.position(v)[axis] * 1048576) / 1048576 + shift[axis]);
    return points;
}

// Returns an empty string if the polygons and the points' mesh edges and parameters t are equal to the bit. Positions
// and normals are not compared.
std::string other_polygons(const Surface& a, const Surface& b) {
    if (a.polygon_offset != b.polygon_offset || a.polygon_vertex != b.polygon_vertex) return "polygons";
    if (a.polygon_cell != b.polygon_cell) return "cells";
    if (a.points.size() != b.points.size()) return "number of points";
    for (std::size_t i = 0; i < a.points.size(); ++i)
        if (a.points[i].a != b.points[i].a || a.points[i].b != b.points[i].b || a.points[i].t != b.points[i].t)
            return "point " + std::to_string(i);
    return "";
}

class DoublePositions : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
};

constexpr std::array algorithms{Algorithm::signatures, Algorithm::propagation, Algorithm::naive};

struct CutMesh {
    const DoubleMesh& mesh;
    const Field& field;
};

// Cuts both meshes with each algorithm at each value and expects the same polygons. Calls check(surface, other surface)
// for each pair.
template <class Check>
void expect_same_polygons(const CutMesh& here, const CutMesh& there, const std::vector<double>& values, bool normals,
                          Check&& check) {
    for (const Algorithm algorithm : algorithms) {
        Query query(here.mesh.topology, here.mesh.mesh(), {algorithm});
        Query other(there.mesh.topology, there.mesh.mesh(), {algorithm});
        query.set_field(here.field);
        other.set_field(there.field);
        for (const double nu : values) {
            Surface expected, found;
            query.extract(nu, normals, expected);
            other.extract(nu, normals, found);
            ASSERT_EQ(other_polygons(expected, found), "") << nu;
            check(expected, found);
        }
    }
}

TEST_P(DoublePositions, ThatAreFloatsGiveTheSurfacesOfFloats) {
    if (input.vertex_count() == 0) return;
    input.origin = {};
    const KernelMesh floats(input, {16});
    const DoubleMesh doubles(input, {input.positions.begin(), input.positions.end()}, {});
    ASSERT_TRUE(doubles.mesh().positions.has_doubles());
    const std::vector<float> values = floats.stored(bumps_field(input, 3));
    const Field field(floats.topology, values, kept_by_test), other_field(doubles.topology, values, kept_by_test);
    EXPECT_EQ(vertex_gradients(floats.topology, floats.mesh(), values),
              vertex_gradients(doubles.topology, doubles.mesh(), values));
    for (const Algorithm algorithm : algorithms) {
        Query query = floats.query(algorithm), other(doubles.topology, doubles.mesh(), {algorithm});
        query.set_field(field);
        other.set_field(other_field);
        for (const double nu : walk_through(values, 6, 11)) {
            Surface expected, found;
            query.extract(nu, true, expected);
            other.extract(nu, true, found);
            ASSERT_EQ(bit_difference(expected, found), "") << nu;
        }
    }
    const std::vector<double> middle{field.range()[0] / 2 + field.range()[1] / 2};
    std::vector<std::vector<Vec3f>> expected, found;
    EXPECT_TRUE(sweep(floats.topology, floats.mesh(), field, middle, SoupSink{}, expected));
    EXPECT_TRUE(sweep(doubles.topology, doubles.mesh(), other_field, middle, SoupSink{}, found));
    EXPECT_EQ(expected, found);
    EXPECT_EQ(bit_difference(face_surface(floats.mesh(), boundary_faces(floats.mesh())),
                             face_surface(doubles.mesh(), boundary_faces(doubles.mesh()))),
              "");
}

TEST_P(DoublePositions, FarAwayGiveThePolygonsOfTheSameMeshNearby) {
    if (input.vertex_count() == 0) return;
    const DoubleMesh here(input, points_of(input, {}), {}), there(input, points_of(input, survey), survey);
    ASSERT_EQ(here.assembled.original_vertex, there.assembled.original_vertex);
    ASSERT_EQ(here.assembled.original_cell, there.assembled.original_cell);
    const std::vector<float> values = here.stored(bumps_field(input, 5));
    const Field field(here.topology, values, kept_by_test), far_field(there.topology, values, kept_by_test);
    const auto walk = walk_through(values, 4, 12);
    expect_same_polygons({here, field}, {there, far_field}, walk, true, [&](const Surface& near, const Surface& far) {
        for (std::size_t i = 0; i < far.points.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double moved = here.place(near.points[i])[axis] + survey[axis];
                ASSERT_NEAR(there.place(far.points[i])[axis], moved, std::abs(moved) * 2.3e-16);
                ASSERT_NEAR(far.positions[i][axis], near.positions[i][axis], 1e-6);
                ASSERT_NEAR(far.normals[i][axis], near.normals[i][axis], 1e-4);
            }
    });
}

TEST_P(DoublePositions, FarAwayAreSlicedLikeTheSameMeshNearby) {
    if (input.vertex_count() == 0) return;
    const DoubleMesh here(input, points_of(input, {}), {}), there(input, points_of(input, survey), survey);
    const auto plane = [](const DoubleMesh& mesh, const Vec3d& normal) {
        const Vec3d at{mesh.origin[0] + 0.25, mesh.origin[1] + 0.5, mesh.origin[2] + 0.125};
        return Field::plane(mesh.topology, mesh.mesh(), at, normal, block_boxes(mesh.topology, mesh.mesh().positions));
    };
    for (const Vec3d& normal : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, -1}}) {
        const Field field = plane(here, normal), far_field = plane(there, normal);
        EXPECT_EQ(field.range(), far_field.range());
        expect_same_polygons({here, field}, {there, far_field}, {0.0, 0.3, -0.2, 1e-9}, false,
                             [](const Surface&, const Surface&) {});
    }
    const Vec3d oblique{0.6, -0.48, 0.64};
    const Field field = plane(there, oblique);
    Query query(there.topology, there.mesh(), {});
    query.set_field(field);
    Surface cut;
    query.extract(0.05, false, cut);
    for (const EdgePoint& point : cut.points) {
        const Vec3d at = there.place(point);
        double distance = -0.05;
        for (std::size_t axis = 0; axis < 3; ++axis)
            distance += oblique[axis] * (at[axis] - survey[axis] - std::array{0.25, 0.5, 0.125}[axis]);
        ASSERT_NEAR(distance, 0, 5e-9); // a few units in the last place of 4,500,000
    }
}

INSTANTIATE_TEST_SUITE_P(All, DoublePositions, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// A wall at z = 60 under a far field that reaches to z = 160: the lowest cells are 2e-6 high.
class BoundaryLayer : public testing::Test {
protected:
    static constexpr int layers = 40, across = 3;
    static constexpr double wall = 60, thinnest = 2e-6;

    [[nodiscard]] static double height(int layer) { // above the wall
        const double growth = std::pow(100 / thinnest, 1.0 / (layers - 1));
        return layer == 0 ? 0 : thinnest * std::pow(growth, layer - 1);
    }
    [[nodiscard]] static int layer_of(const Polyhedra& box, Id vertex) {
        return static_cast<int>(std::lround(box.position(vertex)[2]));
    }

    Polyhedra box = hexahedra({{across, across, layers}});
    std::vector<double> points = [this] {
        std::vector<double> all;
        for (Id v = 0; v < box.vertex_count(); ++v) {
            const Point p = box.position(v);
            all.insert(all.end(), {p[0], p[1], wall + height(layer_of(box, v))});
        }
        return all;
    }();
    const DoubleMesh mesh{box, points, {1, 1, wall}};
};

TEST_F(BoundaryLayer, KeepsItsHeights) {
    std::vector<float> layer(box.vertex_count());
    for (Id v = 0; v < layer.size(); ++v) layer[v] = static_cast<float>(layer_of(box, v));
    const std::vector<float> stored = mesh.stored(layer);
    const Field field(mesh.topology, stored, kept_by_test);
    Query query(mesh.topology, mesh.mesh(), {});
    query.set_field(field);
    for (int below = 0; below < 12; ++below) {
        Surface cut;
        query.extract(below + 0.5, false, cut);
        ASSERT_EQ(cut.polygon_cell.size(), std::size_t{across * across});
        const double expected = (height(below) + height(below + 1)) / 2;
        for (std::size_t i = 0; i < cut.points.size(); ++i) {
            EXPECT_NEAR(mesh.place(cut.points[i])[2] - wall, expected, 1e-3 * thinnest);
            EXPECT_NEAR(cut.positions[i][2], expected, 1e-3 * thinnest + 1e-7 * expected);
        }
    }
}

TEST_F(BoundaryLayer, IsSlicedCellByCell) {
    const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
    const Field distance = Field::plane(mesh.topology, mesh.mesh(), {0, 0, 0}, {0, 0, 1}, boxes);
    Query query(mesh.topology, mesh.mesh(), {});
    query.set_field(distance);
    for (int below = 0; below < layers; ++below) {
        const double middle = (height(below) + height(below + 1)) / 2;
        Surface cut;
        query.extract(wall + middle, false, cut);
        ASSERT_EQ(cut.polygon_cell.size(), std::size_t{across * across}) << below;
        for (std::size_t i = 0; i < cut.points.size(); ++i)
            ASSERT_NEAR(cut.positions[i][2], middle, 1e-3 * thinnest + 1e-7 * middle) << below;
    }
}

TEST_F(BoundaryLayer, HasTheCellsAndGradientsOfItsHeights) {
    const CellLocator locator(mesh.topology, mesh.mesh(),
                              std::make_shared<const BlockBoxes>(block_boxes(mesh.topology, mesh.mesh().positions)));
    std::vector<float> values(box.vertex_count());
    for (Id v = 0; v < values.size(); ++v) values[v] = static_cast<float>(points[3 * std::size_t{v} + 2] - wall);
    const std::vector<Vec3f> gradients = vertex_gradients(mesh.topology, mesh.mesh(), mesh.stored(values));
    for (const Vec3f& gradient : gradients) {
        EXPECT_NEAR(gradient[2], 1, 1e-3);
        EXPECT_NEAR(std::hypot(gradient[0], gradient[1]), 0, 1e-2);
    }
    for (int below = 0; below < layers; ++below) {
        const Vec3d inside{1.5, 1.5, wall + (height(below) + height(below + 1)) / 2};
        const Index cell = locator.cell_at(inside);
        ASSERT_NE(cell, none) << below;
        double lowest = std::numeric_limits<double>::infinity();
        for (const auto& [vertex, weight] : locator.weights_in(cell, inside))
            lowest = std::min(lowest, mesh.mesh().positions[3 * std::size_t{vertex} + 2] - wall);
        EXPECT_NEAR(lowest, height(below), 1e-3 * thinnest) << below;
    }
}

// Clips the boundary by the points' double positions. The cut must be at the height of the plane, 11e-6 above the wall.
TEST_F(BoundaryLayer, IsClippedWhereItsPlacesAre) {
    const Surface sides = face_surface(mesh.mesh(), boundary_faces(mesh.mesh()));
    std::vector<Vec3d> places;
    for (const EdgePoint& point : sides.points) places.push_back(mesh.place(point));
    const double cut = 5.5 * thinnest;
    const std::vector<HalfSpace> above{{{0, 0, 1}, -(wall + cut)}};
    const ClippedSurface clipped = clip_surface(sides, {}, above, 0, places);
    ASSERT_EQ(clipped.places.size(), clipped.surface.positions.size());
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3d& place : clipped.places) lowest = std::min(lowest, place[2]);
    EXPECT_NEAR(lowest - wall, cut, 1e-3 * thinnest);
}

} // namespace
} // namespace ciel::test
