// extract() against the brute-force twin, for every mesh and field, along sequences of values as from a slider.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace ciel::test {
namespace {

class Extract : public testing::TestWithParam<std::tuple<NamedMesh, Algorithm>> {
protected:
    Polyhedra input = std::get<0>(GetParam()).make();
    Algorithm algorithm = std::get<1>(GetParam());
    KernelMesh mesh{input, {32}};
    Query query = mesh.query(algorithm);
    Surface surface;

    // Expects the twin's surface at nu, valid arrays, and a closed surface.
    void expect_right(const std::vector<float>& values, double nu) {
        ASSERT_TRUE(query.extract(nu, false, surface));
        const Cut actual = mesh.cut(surface);
        ASSERT_EQ(difference(cut_every_cell(input, values, nu), actual), "");
        ASSERT_EQ(broken_promise(surface, mesh, mesh.stored(values), nu, false), "");
        const Segments segments = polygon_segments(actual.polygons);
        ASSERT_EQ(open_segment(segments, boundary_segments(input, values, nu)), "");
        // Exactly two polygons share each inner edge.
        for (const auto& [segment, count] : segments) ASSERT_EQ(count, 1);
    }
};

TEST_P(Extract, EqualsTheTwinOnAnyWalk) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        query.set_field(field);
        for (double nu : walk_through(values, 24, 51)) {
            SCOPED_TRACE(named.name + " at " + std::to_string(nu));
            expect_right(values, nu);
            if (HasFatalFailure()) return;
        }
    }
}

// The field changes between extractions, as during playback.
TEST_P(Extract, EqualsTheTwinAfterEveryChangeOfField) {
    for (std::uint64_t step = 0; step < 12; ++step) {
        SCOPED_TRACE("seed " + std::to_string(step));
        const std::vector<float> values =
            step % 3 == 2 ? tied_field(input.vertex_count(), 3, step) : random_field(input.vertex_count(), step);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        query.set_field(field);
        expect_right(values, 0.5);
        if (step % 2 == 0) expect_right(values, 1.0);
        if (HasFatalFailure()) return;
    }
}

TEST_P(Extract, ASeriesIsEachValueInTheOrderGiven) {
    const std::vector<float> values = bumps_field(input, 52);
    const Field field = make_field(mesh.topology, mesh.stored(values));
    query.set_field(field);
    const std::vector<double> nus = walk_through(values, 8, 53);
    std::vector<double> seen;
    ASSERT_TRUE(extract_series(query, nus, true, [&](double nu, Surface&& kept) {
        seen.push_back(nu);
        const Surface mine = std::move(kept);
        EXPECT_EQ(difference(cut_every_cell(input, values, nu), mesh.cut(mine)), "") << nu;
        EXPECT_EQ(broken_promise(mine, mesh, mesh.stored(values), nu, true), "") << nu;
    }));
    EXPECT_EQ(seen, nus);
}

TEST_P(Extract, AStoppedCallSaysSoAndHarmsNothing) {
    const std::vector<float> values = random_field(input.vertex_count(), 54);
    const Field field = make_field(mesh.topology, mesh.stored(values));
    query.set_field(field);
    expect_right(values, 0.25);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(query.extract(0.75, true, surface, stop.get_token()));
    expect_right(values, 0.5);
    expect_right(values, 0.25);
}

TEST_P(Extract, CellsThatTouchAVertexWithoutAValueAreNotCut) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::array none_of_these{std::numeric_limits<float>::quiet_NaN(), infinity, -infinity};
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::vector<float> values = random_field(input.vertex_count(), seed);
        const std::vector<float> holes = random_field(input.vertex_count(), seed + 100);
        for (std::size_t v = 0; v < values.size(); ++v) {
            if (holes[v] < (seed == 5 ? 1.0F : 0.05F)) values[v] = none_of_these[(v + seed) % 3];
        }
        const Field field = make_field(mesh.topology, mesh.stored(values));
        query.set_field(field);
        for (double nu : {0.5, 0.6, 0.1, 0.5}) {
            expect_right(values, nu);
            for (const EdgePoint& point : surface.points) {
                ASSERT_TRUE(std::isfinite(field.values()[point.a]) && std::isfinite(field.values()[point.b]));
            }
            if (HasFatalFailure()) return;
        }
    }
}

TEST_P(Extract, ValuesThatAreNoNumbersGiveNothing) {
    const std::vector<float> values = random_field(input.vertex_count(), 55);
    const Field field = make_field(mesh.topology, mesh.stored(values));
    query.set_field(field);
    const double infinity = std::numeric_limits<double>::infinity();
    for (double nu : {std::nan(""), infinity, -infinity, 1e300, -1e300}) {
        expect_right(values, 0.5);
        ASSERT_TRUE(query.extract(nu, true, surface));
        EXPECT_TRUE(surface.polygon_cell.empty()) << nu;
        EXPECT_TRUE(surface.points.empty()) << nu;
    }
}

const char* name_of(Algorithm algorithm) {
    switch (algorithm) {
    case Algorithm::propagation:
        return "propagation";
    case Algorithm::naive:
        return "naive";
    case Algorithm::signatures:
        break;
    }
    return "signatures";
}

INSTANTIATE_TEST_SUITE_P(
    All, Extract,
    testing::Combine(testing::ValuesIn(all_meshes()),
                     testing::Values(Algorithm::signatures, Algorithm::propagation, Algorithm::naive)),
    [](const auto& test) { return std::get<0>(test.param).name + "_" + name_of(std::get<1>(test.param)); });

// A face that runs along an edge and back. When only that edge is active, no polygon uses its point.
TEST(ExtractSpike, AnEdgeThatAFaceRunsAlongTwiceHasNoPointOfItsOwn) {
    const Polyhedra cube = hexahedra({{1, 1, 1}});
    Polyhedra input = keep_cells(cube, [](Id) { return false; });
    const Id tip = input.add_vertex({0.5, 0.5, 2});
    std::vector<Loop> loops = cube.loops(0);
    loops.back().insert(loops.back().begin() + 1, {tip, loops.back().front()});
    input.add_cell(polyhedron, loops);
    const KernelMesh mesh(input);
    std::vector<float> values(input.vertex_count(), 0);
    values[tip] = 1;
    values[loops[0][0]] = 2;
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive}) {
        Query query = mesh.query(algorithm);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        query.set_field(field);
        Surface surface;
        ASSERT_TRUE(query.extract(0.5, true, surface));
        EXPECT_EQ(difference(cut_every_cell(input, values, 0.5), mesh.cut(surface)), "");
        EXPECT_EQ(broken_promise(surface, mesh, mesh.stored(values), 0.5, true), "");
    }
}

// Values near the limits of float32, where differences overflow.
TEST(ExtractExtremes, PositionsStayFinite) {
    const Polyhedra input = tetrahedra({{3, 3, 3}});
    const KernelMesh mesh(input);
    const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
    for (const auto& palette :
         {std::vector{-huge, huge}, {-tiny, tiny, 0.0F}, {0.0F, -0.0F, tiny}, {-huge, 0.0F, 1.0F, huge}}) {
        std::vector<float> values = tied_field(input.vertex_count(), static_cast<int>(palette.size()), 57);
        for (float& value : values) value = palette[static_cast<std::size_t>(value)];
        const Field field = make_field(mesh.topology, mesh.stored(values));
        for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
            Query query = mesh.query(algorithm);
            query.set_field(field);
            for (float nu : palette) {
                Surface surface;
                ASSERT_TRUE(query.extract(nu, true, surface));
                for (const Vec3f& p : surface.positions) EXPECT_TRUE(std::isfinite(p[0] + p[1] + p[2])) << nu;
                for (const Vec3f& n : surface.normals) EXPECT_TRUE(std::isfinite(n[0] + n[1] + n[2])) << nu;
                EXPECT_EQ(difference(cut_every_cell(input, values, nu), mesh.cut(surface)), "") << nu;
            }
        }
    }
}

} // namespace
} // namespace ciel::test
