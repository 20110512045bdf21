// Fields: ranges, minima, ambiguous faces, gradients, slices.
#include "blocks/blocks.hpp"
#include "fields/field_data.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel::test {
namespace {

std::vector<Vec3f> gradients_of(const KernelMesh& mesh, const std::vector<float>& stored) {
    std::vector<Vec3f> gradients = vertex_gradients(mesh.mesh(), stored);
    EXPECT_EQ(gradients.size(), mesh.mesh().vertex_count());
    return gradients;
}

class Fields : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {16}};

    std::vector<std::set<Index>> neighbours() const {
        std::vector<std::set<Index>> result(mesh.mesh().vertex_count());
        for (Index f = 0; f < mesh.mesh().face_count(); ++f) {
            const auto loop = mesh.mesh().loop(f);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Index a = loop[i], b = loop[(i + 1) % loop.size()];
                if (a == b) continue;
                result[a].insert(b);
                result[b].insert(a);
            }
        }
        return result;
    }
};

TEST_P(Fields, MinimaAreThoseOfTheOrderByValueAndId) {
    const auto around = neighbours();
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = mesh.stored(named.make(input));
        const auto less = [&](Index a, Index b) { return std::pair(values[a], a) < std::pair(values[b], b); };
        std::vector<Index> expected;
        for (Index v = 0; v < values.size(); ++v) {
            if (std::all_of(around[v].begin(), around[v].end(), [&](Index n) { return less(v, n); }))
                expected.push_back(v);
        }
        std::sort(expected.begin(), expected.end(), less);
        const Field field = make_field(mesh.topology, values);
        const auto minima = field.sorted_minima();
        EXPECT_EQ(std::vector<Index>(minima.begin(), minima.end()), expected) << named.name;
    }
}

TEST_P(Fields, RangeIsOfFiniteValues) {
    std::vector<float> values = mesh.stored(random_field(input.vertex_count(), 121));
    if (values.empty()) {
        EXPECT_EQ(make_field(mesh.topology, values).range(), (std::array{0.0, 0.0}));
        return;
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_EQ(make_field(mesh.topology, values).range(), (std::array<double, 2>{*low, *high}));
    const float infinity = std::numeric_limits<float>::infinity();
    for (float bad : {std::nanf(""), infinity, -infinity}) {
        std::vector<float> holed = values;
        holed[0] = bad;
        const auto [l, h] = std::minmax_element(values.begin() + 1, values.end());
        EXPECT_EQ(make_field(mesh.topology, holed).range(), (std::array<double, 2>{*l, *h})) << bad;
        EXPECT_EQ(make_field(mesh.topology, std::vector<float>(values.size(), bad)).range(), (std::array{0.0, 0.0}));
    }
}

TEST_P(Fields, AmbiguousFacesHaveSeveralMaximaAroundThem) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = mesh.stored(named.make(input));
        const auto above = [&](Index a, Index b) { return std::pair(values[a], a) > std::pair(values[b], b); };
        std::uint64_t expected = 0;
        for (Index f = 0; f < mesh.mesh().face_count(); ++f) {
            const auto corners = mesh.mesh().loop(f);
            const Loop loop = without_repeats({corners.begin(), corners.end()});
            const std::size_t n = loop.size();
            int maxima = 0;
            for (std::size_t i = 0; n > 1 && i < n; ++i) {
                maxima += above(loop[i], loop[(i + 1) % n]) && above(loop[i], loop[(i + n - 1) % n]) ? 1 : 0;
            }
            expected += maxima > 1 ? 1 : 0;
        }
        EXPECT_EQ(count_ambiguous_faces(mesh.topology, mesh.mesh(), values), expected) << named.name;
    }
}

TEST_P(Fields, GradientsOfLinearFieldsAreExact) {
    for (const Point& gradient : {Point{1, 0, 0}, Point{0, -3, 0}, Point{0.25, 2, -1}}) {
        const std::vector<float> values = mesh.stored(linear_field(input, {gradient, 0.5}));
        for (const Vec3f& g : gradients_of(mesh, values)) {
            for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(g[d], gradient[d], 2e-4);
        }
    }
}

TEST_P(Fields, GradientsOfAConstantAreZero) {
    const std::vector<float> values(mesh.mesh().vertex_count(), 7.0F);
    for (const Vec3f& g : gradients_of(mesh, values)) EXPECT_EQ(g, (Vec3f{0, 0, 0}));
}

TEST_P(Fields, GradientsStayFiniteBesideNaN) {
    std::vector<float> values = mesh.stored(random_field(input.vertex_count(), 122));
    for (std::size_t v = 0; v < values.size(); v += 5) values[v] = std::nanf("");
    const std::vector<Vec3f> gradients = gradients_of(mesh, values);
    ASSERT_EQ(gradients.size(), values.size());
    for (std::size_t v = 0; v < values.size(); ++v) {
        const Vec3f& g = gradients[v];
        ASSERT_TRUE(std::isnan(values[v]) || std::isfinite(g[0] + g[1] + g[2])) << v;
    }
}

TEST_P(Fields, PlaneDistanceIsTheScalarProduct) {
    const Vec3d origin{0.5, -1, 2}, normal{0.6, 0, 0.8};
    const std::vector<float> distance = plane_distance(mesh.mesh(), origin, normal);
    ASSERT_EQ(distance.size(), mesh.mesh().vertex_count());
    for (Index v = 0; v < distance.size(); ++v) {
        double expected = 0;
        for (std::size_t d = 0; d < 3; ++d) {
            expected += normal[d] * (input.position(mesh.assembled.original_vertex[v])[d] - origin[d]);
        }
        EXPECT_NEAR(distance[v], expected, 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Fields, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// A cell of volume 1 with slope 1 beside a cell of volume 3 with slope 5.
TEST(GradientWeights, AreTheVolumesOfTheCells) {
    Polyhedra input = hexahedra({{2, 1, 1}});
    std::vector<float> values, expected;
    for (Id v = 0; v < input.vertex_count(); ++v) {
        float& x = input.positions[3 * v];
        values.push_back(x == 2 ? 16 : x);
        expected.push_back(x == 0 ? 1.0F : x == 1 ? 4.0F : 5.0F);
        if (x == 2) x = 4;
    }
    const KernelMesh mesh(input);
    const std::vector<Vec3f> gradients = gradients_of(mesh, mesh.stored(values));
    for (Index v = 0; v < gradients.size(); ++v) {
        EXPECT_FLOAT_EQ(gradients[v][0], expected[mesh.assembled.original_vertex[v]]);
        EXPECT_NEAR(gradients[v][1], 0, 1e-5);
        EXPECT_NEAR(gradients[v][2], 0, 1e-5);
    }
}

// Cell edges from 1e-18 to 1e18: the cells' volumes are outside the range of float32.
TEST(GradientScales, DoNotMatter) {
    for (const double edge : {1e-18, 1e-14, 1.0, 1e13, 1e18}) {
        Polyhedra cells = hexahedra({{3, 2, 2}, 0, 1, edge});
        std::ranges::fill(cells.cell_types, std::uint8_t{polyhedron});
        for (const Polyhedra& input :
             {hexahedra({{3, 2, 2}, 0, 1, edge}), tetrahedra({{2, 2, 2}, 0, 1, edge}), cells}) {
            const KernelMesh mesh(input, {4});
            const std::vector<float> values = linear_field(input, {{1 / edge, -2 / edge, 3 / edge}, 4});
            for (const Vec3f& g : gradients_of(mesh, mesh.stored(values))) {
                EXPECT_NEAR(g[0] * edge, 1, 1e-4) << edge;
                EXPECT_NEAR(g[1] * edge, -2, 1e-4) << edge;
                EXPECT_NEAR(g[2] * edge, 3, 1e-4) << edge;
            }
        }
    }
}

TEST(NormalsWithoutAGradient, FollowThePolygons) {
    const Polyhedra input = hexahedra({{1, 1, 1}});
    const KernelMesh mesh(input);
    const std::vector<float> values{1, -1, -1, 1, -1, 1, 1, -1};
    for (const Vec3f& g : gradients_of(mesh, mesh.stored(values))) EXPECT_EQ(g, (Vec3f{0, 0, 0}));
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0, true, surface));
    ASSERT_EQ(surface.polygon_cell.size(), 4U);
    ASSERT_EQ(surface.normals.size(), surface.positions.size());
    for (std::size_t p = 0; p < 4; ++p) {
        const Vec3d area = vector_area(surface.positions, polygon(surface, p));
        for (Index v : polygon(surface, p)) {
            const Vec3f& n = surface.normals[v];
            EXPECT_NEAR(n[0] * area[0] + n[1] * area[1] + n[2] * area[2], std::hypot(area[0], area[1], area[2]), 1e-5);
        }
    }
}

// Coordinates as of a map projection: cells of some meters, positions of millions of meters.
Polyhedra far_away(const Polyhedra& mesh, bool as_origin) {
    const Point shift{500000, 4500000, -2500};
    Polyhedra result = mesh;
    if (as_origin) result.origin = shift;
    for (Id v = 0; !as_origin && v < mesh.vertex_count(); ++v) {
        for (std::size_t d = 0; d < 3; ++d) result.positions[3 * v + d] += static_cast<float>(shift[d]);
    }
    return result;
}

class FarAway : public testing::TestWithParam<bool> {};

TEST_P(FarAway, GradientsOfLinearFieldsAreExact) {
    for (const Polyhedra& near : {tetrahedra({{4, 4, 4}, 0.1, 123, 50}), hexahedra({{4, 4, 4}, 0.1, 124, 50}),
                                  zoo({{4, 4, 4}, 0.1, 125, 50}), hanging_nodes({{3, 3, 3}, 0, 126, 50})}) {
        const Polyhedra input = far_away(near, GetParam());
        const KernelMesh mesh(input);
        const Point gradient{0.25, -1, 0.5};
        LinearField linear{gradient};
        linear.constant = -linear.at(input.position(0)); // keeps the values small, so that float32 is precise enough
        const std::vector<float> values = mesh.stored(linear_field(input, linear));
        for (const Vec3f& g : gradients_of(mesh, values)) {
            for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(g[d], gradient[d], 1e-4);
        }
        const Field field = make_field(mesh.topology, values);
        Query query = mesh.query();
        query.set_field(field);
        Surface surface;
        ASSERT_TRUE(query.extract(3.0, true, surface));
        ASSERT_FALSE(surface.normals.empty());
        const double length = std::hypot(gradient[0], gradient[1], gradient[2]);
        for (const Vec3f& n : surface.normals) {
            for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(n[d], gradient[d] / length, 1e-3);
        }
    }
}

TEST_P(FarAway, SlicesKeepTheirArea) {
    const KernelMesh mesh(far_away(hexahedra({{4, 4, 4}, 0, 127, 64}), GetParam()));
    const Field field =
        make_field(mesh.topology, plane_distance(mesh.mesh(), {500000 + 96, 4500000, -2500}, {1, 0, 0}));
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0, false, surface));
    double area = 0;
    for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p)
        area += vector_area(surface.positions, polygon(surface, p))[0];
    EXPECT_NEAR(area, 256.0 * 256, GetParam() ? 1e-2 : 10);
}

INSTANTIATE_TEST_SUITE_P(Origin, FarAway, testing::Bool(),
                         [](const auto& test) { return test.param ? "in_double" : "in_the_floats"; });

// Cells without any value must have an empty range, so that no cut contains them.
TEST(CellRanges, AreEmptyWhereThereIsNoValue) {
    for (const NamedMesh& named : all_meshes()) {
        const Polyhedra input = named.make();
        const KernelMesh mesh(input, {32});
        const std::vector<float> none_at_all(mesh.topology.counts().vertices, std::numeric_limits<float>::quiet_NaN());
        const Field field = make_field(mesh.topology, none_at_all);
        const Field::Data& blocks = field.data();
        for (Index b = 0; b < mesh.topology.block_count(); ++b) {
            const detail::Block& block = mesh.topology.blocks().cells(b);
            (void)blocks.ranges.of(block, b, blocks.of_block(b)); // the ranges are built by the second call
            for (const detail::CellRanges::Range& range : blocks.ranges.of(block, b, blocks.of_block(b)))
                EXPECT_GT(range[0], range[1]) << named.name;
        }
    }
}

} // namespace
} // namespace ciel::test
