// A sweep over several values in one pass gives the same surfaces as one query per value.
#include "ciel/cell_limits.hpp"
#include "ciel/sweep_sinks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/volume_property.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <mutex>

namespace ciel::test {
using namespace server;
namespace {

struct How {
    const char* name;
    Extraction extraction;
    friend std::ostream& operator<<(std::ostream& out, const How& how) { return out << how.name; }
};

const std::vector<How> ways{
    {"signatures", {}},
    {"propagation", {Algorithm::propagation}},
    {"naive", {Algorithm::naive}},
    {"decided", {Algorithm::signatures, Decider::asymptotic}},
    {"propagation_decided", {Algorithm::propagation, Decider::asymptotic}},
    {"naive_decided", {Algorithm::naive, Decider::asymptotic}},
};

class Sweep : public testing::TestWithParam<std::tuple<NamedMesh, How>> {
protected:
    Polyhedra input = std::get<0>(GetParam()).make();
    Extraction how = std::get<1>(GetParam()).extraction;
    KernelMesh mesh{input, {32}};
    std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 3));
    Field field = make_field(mesh.topology, stored);
    // Unsorted, with a repeated value, two outside the range and a NaN.
    std::vector<double> values{0.5, 0.1, 0.9, 0.5, -1, 2, std::numeric_limits<double>::quiet_NaN(), 0.3};

    Surface surface_at(double nu) {
        Query query(mesh.topology, mesh.mesh(), {Algorithm::signatures, how.decider});
        query.set_field(field);
        Surface surface;
        EXPECT_TRUE(query.extract(nu, false, surface));
        return surface;
    }
    static std::span<const Index> polygon(const Surface& surface, std::size_t i) {
        return std::span(surface.polygon_vertex)
            .subspan(surface.polygon_offset[i], surface.polygon_offset[i + 1] - surface.polygon_offset[i]);
    }
    // Calls f(a, b, c) for each triangle of each polygon's fan.
    template <class F>
    static void for_fans(const Surface& surface, F&& f) {
        for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
            const std::span<const Index> loop = polygon(surface, i);
            for (std::size_t k = 2; k < loop.size(); ++k) f(loop[0], loop[k - 1], loop[k]);
        }
    }
    std::vector<Vec3f> soup_at(double nu) {
        const Surface surface = surface_at(nu);
        std::vector<Vec3f> soup;
        for_fans(surface, [&](Index a, Index b, Index c) {
            for (const Index p : {a, b, c}) soup.push_back(surface.positions[p]);
        });
        return soup;
    }
};

TEST_P(Sweep, ASoupIsTheSurfacesPolygonsAsFans) {
    std::vector<SoupSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SoupSink{}, out, {}, how));
    ASSERT_EQ(out.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(out[i], soup_at(values[i])) << values[i];
}

TEST_P(Sweep, ASliceHasTheSameTrianglesAndThePropertyAtTheirCorners) {
    const std::vector<float> property = mesh.stored(random_field(input.vertex_count(), 4));
    std::vector<SliceSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SliceSink{property}, out, {}, how));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::vector<float> at_points(surface.points.size());
        interpolate(surface.points, property, 1, at_points);
        std::size_t at = 0;
        for_fans(surface, [&](Index a, Index b, Index c) {
            for (const Index p : {a, b, c}) {
                const Index mine = out[i].triangles.at(at++);
                ASSERT_EQ(out[i].positions.at(mine), surface.positions[p]);
                ASSERT_EQ(out[i].property.at(mine), at_points[p]);
            }
        });
        EXPECT_EQ(at, out[i].triangles.size());
    }
}

TEST_P(Sweep, AnOutlineIsThePolygonsEdges) {
    std::vector<OutlineSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, OutlineSink{}, out, {}, how));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::vector<Vec3f> expected;
        for (std::size_t k = 0; k < surface.polygon_cell.size(); ++k) {
            Index before = polygon(surface, k).back();
            for (const Index p : polygon(surface, k)) {
                expected.push_back(surface.positions[before]);
                expected.push_back(surface.positions[p]);
                before = p;
            }
        }
        EXPECT_EQ(out[i], expected) << values[i];
    }
}

// Sweeps with any algorithm make the same arrays as the naive one, also with missing values and with buffers that a
// sweep of another field has left.
TEST_P(Sweep, MakesTheSameArraysAsAnyOther) {
    std::vector<float> gaps = mesh.stored(random_field(input.vertex_count(), 7));
    for (std::size_t v = 0; v < gaps.size(); v += 5) gaps[v] = std::numeric_limits<float>::quiet_NaN();
    const Field other = make_field(mesh.topology, gaps);
    const std::vector<float> property = mesh.stored(random_field(input.vertex_count(), 4));
    SweepBuffers<SliceSink> scratch;
    for (const Field* of : {&other, &std::as_const(field), &other}) {
        std::vector<SliceSink::Out> out, expected;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), *of, values, SliceSink{property}, scratch, out, {}, how));
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), *of, values, SliceSink{property}, expected, {},
                          {Algorithm::naive, how.decider}));
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_EQ(out[i].positions, expected[i].positions);
            EXPECT_EQ(out[i].property, expected[i].property);
            EXPECT_EQ(out[i].triangles, expected[i].triangles);
        }
    }
}

std::vector<std::array<float, 2>> limits_of_faces(const FaceMeshView& mesh, std::span<const float> values,
                                                  const std::vector<bool>& is_empty) {
    std::vector<std::array<float, 2>> limits(mesh.cell_count(), no_limits);
    for (Index face = 0; face < mesh.face_count(); ++face)
        for (const Index cell : {mesh.owner[face], mesh.neighbour[face]})
            if (cell != none && !is_empty[cell])
                for (const Index vertex : mesh.loop(face))
                    limits[cell] = {std::min(limits[cell][0], values[vertex]),
                                    std::max(limits[cell][1], values[vertex])};
    return limits;
}

// NaN and infinite values count as missing. The slab is finite and covers every cell whose vertices all have values.
TEST_P(Sweep, ASlabLeavesOutWhatHasNoValue) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<float> property = mesh.stored(random_field(input.vertex_count(), 5));
    for (std::size_t v = 3; v < property.size(); v += 17) property[v] = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t v = 7; v < property.size(); v += 29) property[v] = infinity;
    for (std::size_t v = 9; v < property.size(); v += 31) property[v] = -infinity;
    std::vector<bool> is_empty(mesh.mesh().cell_count());
    const FaceMeshView faces = mesh.mesh();
    for (Index face = 0; face < faces.face_count(); ++face)
        for (const Index vertex : faces.loop(face))
            if (!std::isfinite(property[vertex])) {
                is_empty[faces.owner[face]] = true;
                if (faces.neighbour[face] != none) is_empty[faces.neighbour[face]] = true;
            }
    const auto expected_limits = limits_of_faces(faces, property, is_empty);
    CellLimits limits(mesh.topology);
    for (Index cell = 0; cell < expected_limits.size(); ++cell)
        ASSERT_EQ(limits.of(cell, property), expected_limits[cell]);
    EXPECT_THROW((void)limits.of(faces.cell_count(), property), Error);
    const VolumeProperty volume(mesh.topology, faces, property);
    std::vector<geometry::SlabSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, faces, field, values, geometry::SlabSink{volume.view()}, out, {}, how));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Surface surface = surface_at(values[i]);
        std::size_t expected = 0;
        for (std::size_t k = 0; k < surface.polygon_cell.size(); ++k)
            if (!is_empty[surface.polygon_cell[k]]) expected += polygon(surface, k).size() - 2;
        EXPECT_EQ(out[i].triangles.size(), 3 * expected);
        for (std::size_t k = 0; k < out[i].triangles.size(); ++k) {
            const color::SlabVertex& vertex = out[i].vertices.at(out[i].triangles[k]);
            ASSERT_TRUE(std::isfinite(vertex.value));
            ASSERT_TRUE(k % 3 != 0 || (std::isfinite(vertex.limits[0]) && vertex.limits[0] <= vertex.limits[1]));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Sweep, testing::Combine(testing::ValuesIn(all_meshes()), testing::ValuesIn(ways)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

// One scratch buffer serves meshes of different sizes, as during playback over a changing mesh.
TEST(SweepBuffers, ServeAnotherMesh) {
    SweepBuffers<SoupSink> scratch;
    for (const int edge : {4, 2, 5}) {
        const Polyhedra input = hexahedra({{edge, edge, edge}});
        const KernelMesh mesh(input, {8});
        const Field field = make_field(mesh.topology, mesh.stored(random_field(input.vertex_count(), 3)));
        std::vector<SoupSink::Out> out, expected;
        const std::vector<double> values{0.4, 0.6};
        ASSERT_TRUE(
            sweep(mesh.topology, mesh.mesh(), field, values, SoupSink{}, scratch, out, {}, {Algorithm::propagation}));
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SoupSink{}, expected));
        EXPECT_EQ(out, expected);
        EXPECT_FALSE(out[0].empty());
    }
}

TEST_P(Sweep, ACallbackGetsEveryPolygonWithItsValue) {
    std::vector<std::size_t> polygons(values.size());
    std::mutex mutex;
    SweepScratch scratch;
    const auto count = [&](std::size_t value, Index block, const BlockPolygons& cut) {
        const std::scoped_lock lock(mutex);
        EXPECT_LT(block, mesh.topology.block_count());
        EXPECT_GT(cut.polygon_count(), 0U);
        polygons[value] += cut.polygon_count();
    };
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, count, scratch, {}, how));
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(polygons[i], surface_at(values[i]).polygon_cell.size()) << values[i];
}

TEST(SweepCallback, AnExceptionEndsTheSweep) {
    const Polyhedra input = hexahedra({{4, 4, 4}});
    const KernelMesh mesh(input, {8});
    const Field field = make_field(mesh.topology, mesh.stored(random_field(input.vertex_count(), 3)));
    SweepScratch scratch;
    const auto refuse = [](std::size_t, Index, const BlockPolygons&) { throw Error("enough"); };
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive})
        EXPECT_THROW(sweep(mesh.topology, mesh.mesh(), field, std::vector{0.5}, refuse, scratch, {}, algorithm), Error);
}

TEST(SweepStopped, SaysSo) {
    const Polyhedra input = hexahedra({{4, 4, 4}});
    const KernelMesh mesh(input, {8});
    const std::vector<float> stored = mesh.stored(random_field(input.vertex_count(), 3));
    const Field field = make_field(mesh.topology, stored);
    std::stop_source stop;
    stop.request_stop();
    std::vector<SoupSink::Out> out;
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive})
        EXPECT_FALSE(
            sweep(mesh.topology, mesh.mesh(), field, std::vector{0.5}, SoupSink{}, out, stop.get_token(), algorithm));
}

TEST_P(Sweep, PassesOverCellsWithoutAllTheirValues) {
    for (std::size_t v = 0; v < stored.size(); v += 7) stored[v] = std::numeric_limits<float>::quiet_NaN();
    field = make_field(mesh.topology, stored);
    std::vector<SoupSink::Out> out;
    ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, values, SoupSink{}, out, {}, how));
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(out[i], soup_at(values[i])) << values[i];
}

TEST_P(Sweep, WantsAPropertyPerVertex) {
    const std::vector<float> more(stored.size() + 1);
    std::vector<SliceSink::Out> out;
    EXPECT_THROW(sweep(mesh.topology, mesh.mesh(), field, values, SliceSink{more}, out, {}, how), Error);
}

} // namespace
} // namespace ciel::test
