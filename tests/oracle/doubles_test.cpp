// Fields of doubles whose values would be equal as floats are cut as exactly as fields of floats.
#include "ciel/contour.hpp"
#include "ciel/threshold_surface.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

constexpr std::array algorithms{Algorithm::signatures, Algorithm::propagation, Algorithm::naive};

// Rounds to multiples of 2^-16, so that `raised` is exact.
float coarse(double value) { return static_cast<float>(std::round(value * 65536) / 65536 + 0.0); } // + 0: never -0

// A pressure of about 1e6 that varies by about 1e-4. As a float it would be one number.
double raised(double value) { return 1048576 + value / 16384; }

class Doubles : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {16}};

    [[nodiscard]] std::vector<float> floats(const NamedField& named) const {
        std::vector<float> values = mesh.stored(named.make(input));
        std::ranges::transform(values, values.begin(), coarse);
        return values;
    }
    static std::vector<double> raised_all(const std::vector<float>& values) {
        std::vector<double> all(values.size());
        std::ranges::transform(values, all.begin(), [](float value) { return raised(value); });
        return all;
    }

    // Cuts the floats at each value nu of the walk and the doubles at nu_of(nu), and expects equal surfaces.
    void expect_same_cuts(const Field& floats, const Field& doubles, const std::vector<double>& walk,
                          double (*nu_of)(double), bool normals) const {
        for (const Algorithm algorithm : algorithms) {
            Query query = mesh.query(algorithm), other = mesh.query(algorithm);
            query.set_field(floats);
            other.set_field(doubles);
            for (const double nu : walk) {
                Surface expected, found;
                ASSERT_TRUE(query.extract(nu, normals, expected));
                ASSERT_TRUE(other.extract(nu_of(nu), normals, found));
                ASSERT_EQ(bit_difference(expected, found), "") << nu;
            }
        }
    }
};

TEST_P(Doubles, ThatAreFloatsAreCutLikeFloats) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = mesh.stored(named.make(input));
        const std::vector<double> wide(values.begin(), values.end());
        const Field field(mesh.topology, values, kept_by_test), doubles(mesh.topology, wide, kept_by_test);
        EXPECT_EQ(field.range(), doubles.range());
        SCOPED_TRACE(named.name);
        expect_same_cuts(
            field, doubles, walk_through(values, 8, 501), [](double nu) { return nu; }, true);
    }
}

TEST_P(Doubles, OfALargeSumAreCutLikeTheirDifferences) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = floats(named);
        const std::vector<double> high = raised_all(values);
        const Field field(mesh.topology, values, kept_by_test), doubles(mesh.topology, high, kept_by_test);
        EXPECT_THAT(doubles.sorted_minima(), testing::ElementsAreArray(field.sorted_minima()));
        std::vector<double> walk = walk_through(values, 8, 502);
        std::ranges::transform(walk, walk.begin(), coarse);
        SCOPED_TRACE(named.name);
        expect_same_cuts(field, doubles, walk, raised, false);
    }
}

TEST_P(Doubles, OfALargeSumHaveTheirGradients) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = floats(named);
        const std::vector<Vec3f> expected = vertex_gradients(mesh.topology, mesh.mesh(), values),
                                 found = vertex_gradients(mesh.topology, mesh.mesh(), raised_all(values));
        float longest = 0;
        for (const Vec3f& gradient : expected)
            longest = std::max(longest, std::hypot(gradient[0], gradient[1], gradient[2]));
        for (std::size_t v = 0; v < expected.size(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(found[v][axis] * 16384, expected[v][axis], 1e-4 * longest) << named.name << " " << v;
    }
}

TEST_P(Doubles, HaveTheIsoValueAtThePointsOfTheSurface) {
    for (const NamedField& named : all_fields()) {
        std::vector<double> values;
        for (const float value : mesh.stored(named.make(input))) values.push_back(101325 + 0.01 * double{value});
        const Field field(mesh.topology, values, kept_by_test);
        Query query = mesh.query();
        query.set_field(field);
        const auto [low, high] = field.range();
        const double nu = low + 0.4321 * (high - low);
        Surface surface;
        ASSERT_TRUE(query.extract(nu, false, surface));
        std::vector<double> found(surface.points.size());
        interpolate(surface.points, std::span<const double>(values), 1, found);
        for (const double value : found) ASSERT_NEAR(value, nu, 5e-11) << named.name; // a few last digits of 101325
    }
}

TEST_P(Doubles, WithoutAValueLeaveTheirCellsUncut) {
    if (input.vertex_count() < 8) return;
    std::vector<float> values = floats(all_fields()[0]);
    std::vector<double> high = raised_all(values);
    for (std::size_t v = 3; v < values.size(); v += 11) {
        values[v] = std::numeric_limits<float>::infinity();
        high[v] = v % 2 == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    }
    const Field field(mesh.topology, values, kept_by_test), doubles(mesh.topology, high, kept_by_test);
    expect_same_cuts(field, doubles, {0.25, 0.5, 0.75, 0.5}, raised, false);
}

INSTANTIATE_TEST_SUITE_P(All, Doubles, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// Ids that are different doubles but the same float, such as 16,777,216 and 16,777,217.
TEST(DoublesOfLargeIds, StayDifferent) {
    const KernelMesh mesh(hexahedra({{4, 4, 4}}), {8});
    std::vector<double> ids(mesh.topology.counts().vertices);
    for (std::size_t v = 0; v < ids.size(); ++v) ids[v] = 16777216 + static_cast<double>(v % 2);
    const Field field(mesh.topology, ids, kept_by_test);
    EXPECT_EQ(field.range(), (std::array{16777216.0, 16777217.0}));
    EXPECT_EQ(field.value(1), 16777217);
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    for (int time = 0; time < 3; ++time) ASSERT_TRUE(query.extract(16777216.5, true, surface)); // later with CellRanges
    EXPECT_FALSE(surface.points.empty());
    for (const EdgePoint& point : surface.points) EXPECT_EQ(point.t, 0.5);
    std::vector<double> between(surface.points.size());
    interpolate(surface.points, std::span<const double>(ids), 1, between);
    EXPECT_THAT(between, testing::Each(16777216.5));
    const std::vector<std::uint8_t> kept = cells_in_range(std::array{16777216.0, 16777217.0}, {16777217, 16777217});
    EXPECT_THAT(kept, testing::ElementsAre(0, 1));
}

// Values of a caller's array, doubles or integers, are not rounded to floats.
TEST(DoublesOfACaller, AreKept) {
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<std::int64_t> offsets{0, 4}, connectivity{0, 1, 2, 3};
    const std::vector<std::uint8_t> types{10}; // VTK_TETRA
    const Mesh mesh =
        Mesh::from_cells(ArrayView(points, 3), {ArrayView(types), ArrayView(offsets), ArrayView(connectivity)});
    const std::vector<double> pressure{101325, 101325.001, 101325, 101325};
    const Surface surface = contour(mesh, ArrayView(pressure), 101325.0005);
    ASSERT_EQ(surface.polygon_cell.size(), 1U);
    for (const EdgePoint& point : surface.points) EXPECT_NEAR(point.t, 0.5, 1e-6);
    const std::vector<std::int64_t> ids{16777216, 16777217, 16777216, 16777216};
    EXPECT_EQ(contour(mesh, ArrayView(ids), 16777216.5).polygon_cell.size(), 1U);
}

} // namespace
} // namespace ciel::test
