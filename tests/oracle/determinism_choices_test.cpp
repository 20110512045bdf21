// Bit-identical results for any block size, thread count and algorithm, with each decider, normal rule, sweep sink,
// threshold and derived surface.
#include "ciel/clip_surface.hpp"
#include "ciel/contour_lines.hpp"
#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "ciel/threshold_surface.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"
#include "support/volume_property.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <tuple>

namespace ciel::test {
using namespace server;
namespace {

constexpr std::array algorithms{Algorithm::signatures, Algorithm::propagation, Algorithm::naive};

// A configuration that must not affect results.
struct Way {
    unsigned threads;
    Index cells_per_block;
};
constexpr Way ways[]{{1, 4096}, {2, 1}, {5, 7}, {3, 64}, {1, 16}};

std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.threads << " threads, " << way.cells_per_block << " cells per block";
}

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    static_assert(std::is_trivially_copyable_v<T>);
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

class DeterminismOfChoices : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    std::vector<float> values = random_field(input.vertex_count(), 201);
    std::vector<float> others = bumps_field(input, 202);
    std::vector<double> walk = walk_through(values, 6, 203);

    // Calls f(mesh, way) for each way. The kernel mesh is built with that block size and thread count.
    template <class F>
    void in_every_way(F&& f) {
        for (const Way& way : ways) {
            const ThreadCount count(way.threads);
            f(KernelMesh(input, {way.cells_per_block}), way);
        }
    }
};

TEST_P(DeterminismOfChoices, DecidersAndNormals) {
    for (const Decider decider : {Decider::isolate_high, Decider::asymptotic})
        for (const Normals normals : {Normals::gradient, Normals::polygons}) {
            std::vector<Surface> expected;
            in_every_way([&](const KernelMesh& mesh, const Way& way) {
                const Field field = make_field(mesh.topology, mesh.stored(values));
                for (const Algorithm algorithm : algorithms) {
                    Query query(mesh.topology, mesh.mesh(), {algorithm, decider});
                    query.set_normals(normals);
                    query.set_field(field);
                    for (std::size_t i = 0; i < walk.size(); ++i) {
                        Surface found;
                        ASSERT_TRUE(query.extract(walk[i], true, found));
                        if (expected.size() == i) expected.push_back(found);
                        ASSERT_EQ(bit_difference(expected[i], found, Chunks::ignore), "")
                            << walk[i] << ", " << way << ", algorithm " << static_cast<int>(algorithm);
                    }
                }
            });
        }
}

TEST_P(DeterminismOfChoices, SoupsAndOutlines) {
    std::vector<SoupSink::Out> soup;
    std::vector<OutlineSink::Out> outline;
    in_every_way([&](const KernelMesh& mesh, const Way& way) {
        const Field field = make_field(mesh.topology, mesh.stored(values));
        std::vector<SoupSink::Out> found;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, walk, SoupSink{}, found));
        if (soup.empty()) soup = found;
        for (std::size_t i = 0; i < walk.size(); ++i)
            ASSERT_TRUE(same_bits(soup[i], found[i])) << walk[i] << ", " << way;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, walk, OutlineSink{}, found));
        if (outline.empty()) outline = found;
        for (std::size_t i = 0; i < walk.size(); ++i)
            ASSERT_TRUE(same_bits(outline[i], found[i])) << walk[i] << ", " << way;
    });
}

struct SliceCorner {
    Vec3f position;
    float property;
    bool operator==(const SliceCorner&) const = default;
};

// A point on the border of two blocks occurs in both blocks; the triangles are the same.
TEST_P(DeterminismOfChoices, TrianglesOfSlices) {
    std::vector<std::vector<SliceCorner>> expected;
    in_every_way([&](const KernelMesh& mesh, const Way& way) {
        const Field field = make_field(mesh.topology, mesh.stored(values));
        const std::vector<float> property = mesh.stored(others);
        std::vector<SliceSink::Out> found;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, walk, SliceSink{property}, found));
        for (std::size_t i = 0; i < walk.size(); ++i) {
            std::vector<SliceCorner> corners;
            for (const Index p : found[i].triangles)
                corners.push_back({found[i].positions.at(p), found[i].property.at(p)});
            if (expected.size() == i) expected.push_back(corners);
            ASSERT_TRUE(same_bits(expected[i], corners)) << walk[i] << ", " << way;
        }
    });
}

struct SlabCorner {
    Vec3f position;
    float value;
    Vec3f gradient;
    bool operator==(const SlabCorner&) const = default;
    bool operator<(const SlabCorner& other) const {
        return std::tie(position, value, gradient) < std::tie(other.position, other.value, other.gradient);
    }
};
using SlabPolygon = std::pair<std::array<float, 2>, std::vector<SlabCorner>>; // limits, and sorted corners

// The apex of a polygon's fan depends on the other polygons of the block, so polygons are compared by their sorted
// corners.
std::vector<SlabPolygon> polygons_of(const color::SlabTriangles& mesh) {
    std::vector<SlabPolygon> out;
    Index apex = none;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const color::SlabVertex& first = mesh.vertices.at(mesh.triangles[i]);
        if (mesh.triangles[i] != apex) out.push_back({first.limits, {}});
        apex = mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const color::SlabVertex& v = mesh.vertices.at(mesh.triangles[i + k]);
            out.back().second.push_back({v.position, v.value, v.gradient});
        }
    }
    for (auto& [limits, corners] : out) {
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
    return out;
}

TEST_P(DeterminismOfChoices, PolygonsOfSlabs) {
    std::vector<std::vector<SlabPolygon>> expected;
    in_every_way([&](const KernelMesh& mesh, const Way& way) {
        const Field field = make_field(mesh.topology, mesh.stored(values));
        const VolumeProperty property(mesh.topology, mesh.mesh(), mesh.stored(others));
        std::vector<geometry::SlabSink::Out> found;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, walk, geometry::SlabSink{property.view()}, found));
        for (std::size_t i = 0; i < walk.size(); ++i) {
            std::vector<SlabPolygon> polygons = polygons_of(found[i]);
            if (expected.size() == i) expected.push_back(polygons);
            ASSERT_EQ(expected[i], polygons) << walk[i] << ", " << way;
        }
    });
}

// For a fixed block size, the arrays are identical for any number of threads, fan apexes included.
TEST_P(DeterminismOfChoices, SlabsWhateverTheThreads) {
    std::vector<geometry::SlabSink::Out> expected;
    for (const unsigned threads : {1U, 2U, 5U}) {
        const ThreadCount count(threads);
        const KernelMesh mesh(input, {8});
        const Field field = make_field(mesh.topology, mesh.stored(values));
        const VolumeProperty property(mesh.topology, mesh.mesh(), mesh.stored(others));
        std::vector<geometry::SlabSink::Out> found;
        ASSERT_TRUE(sweep(mesh.topology, mesh.mesh(), field, walk, geometry::SlabSink{property.view()}, found));
        if (expected.empty()) expected = found;
        for (std::size_t i = 0; i < walk.size(); ++i) {
            ASSERT_TRUE(same_bits(expected[i].vertices, found[i].vertices)) << walk[i] << ", " << threads;
            ASSERT_TRUE(same_bits(expected[i].triangles, found[i].triangles)) << walk[i] << ", " << threads;
        }
    }
}

TEST_P(DeterminismOfChoices, Thresholds) {
    std::vector<Surface> expected;
    in_every_way([&](const KernelMesh& mesh, const Way& way) {
        const std::vector<float> property = mesh.stored(others);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        Surface cut;
        ASSERT_TRUE(query.extract(0.5, true, cut));
        std::vector<Surface> found;
        for (const InRange vertices : {InRange::all, InRange::any}) {
            const auto kept = cells_in_range(mesh.mesh(), property, {0.2, 0.6}, vertices);
            found.push_back(threshold_surface(mesh.mesh(), kept));
            found.push_back(polygons_of_cells(cut, kept));
        }
        if (expected.empty()) expected = found;
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_EQ(bit_difference(expected[i], found[i], Chunks::ignore), "") << i << ", " << way;
    });
}

struct MadeOfSurface {
    std::vector<Index> edges, bends;
    std::vector<Vec3f> lines;
    ClippedSurface clipped;
};

TEST_P(DeterminismOfChoices, WhatIsMadeOfSurfaces) {
    std::vector<MadeOfSurface> expected;
    in_every_way([&](const KernelMesh& mesh, const Way& way) {
        const std::vector<float> property = mesh.stored(others);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        for (std::size_t i = 0; i < walk.size(); ++i) {
            Surface surface;
            ASSERT_TRUE(query.extract(walk[i], true, surface));
            std::vector<float> at(surface.points.size());
            interpolate(surface.points, property, 1, at);
            const HalfSpace planes[]{{{0.6, -0.48, 0.64}, -0.4}, {{-1, 0.5, 0}, 0.3}};
            MadeOfSurface found{polygon_edges(surface), feature_edges(surface, 30),
                                contour_lines(surface, at, std::vector{0.3, 0.7}),
                                clip_surface(surface, at, planes, 1e-6)};
            if (expected.size() == i) expected.push_back(found);
            ASSERT_EQ(expected[i].edges, found.edges) << walk[i] << ", " << way;
            ASSERT_EQ(expected[i].bends, found.bends) << walk[i] << ", " << way;
            ASSERT_TRUE(same_bits(expected[i].lines, found.lines)) << walk[i] << ", " << way;
            ASSERT_TRUE(same_bits(expected[i].clipped.values, found.clipped.values)) << walk[i] << ", " << way;
            ASSERT_EQ(bit_difference(expected[i].clipped.surface, found.clipped.surface, Chunks::ignore), "")
                << walk[i] << ", " << way;
        }
    });
}

// The surface is folded, so polygons at the fold cancel. The rest of their normals' sum is pure rounding and reveals
// the order of summation.
TEST(DeterminismOfSums, PolygonsThatCancel) {
    const Polyhedra input = hexahedra({{6, 5, 5}});
    const std::vector<float> half = random_field(input.vertex_count(), 204);
    std::vector<Surface> expected;
    std::size_t cancelled = 0;
    for (const Way& way : ways) {
        const ThreadCount count(way.threads);
        const KernelMesh mesh(input, {way.cells_per_block});
        std::vector<float> positions(mesh.mesh().positions.begin(), mesh.mesh().positions.end()), values;
        for (std::size_t v = 0; v < positions.size(); v += 3) {
            float* p = &positions[v];
            p[0] = 3 - std::abs(p[0] - 3);
            // The same number on both sides of the fold, so that values and positions coincide.
            const auto place = static_cast<std::size_t>(p[0] + 7 * (p[1] + 6 * p[2]));
            values.push_back(half[place]);
            for (std::size_t d = 0; d < 3; ++d)
                p[d] = std::ldexp(p[d] + 0.3F * half[(place * (d + 3) + 11) % half.size()],
                                  static_cast<int>(place * (d + 5) % 24)); // makes the sums inexact
        }
        FaceMeshView folded = mesh.mesh();
        folded.positions = positions;
        const Field field = make_field(mesh.topology, values);
        Query query(mesh.topology, folded);
        query.set_normals(Normals::polygons);
        query.set_field(field);
        for (std::size_t i = 0; i < 9; ++i) {
            Surface found;
            ASSERT_TRUE(query.extract(0.1 + 0.1 * static_cast<double>(i), true, found));
            if (expected.size() == i) expected.push_back(found);
            for (const Vec3f& normal : found.normals) cancelled += normal == Vec3f{} ? 1 : 0;
            ASSERT_EQ(bit_difference(expected[i], found, Chunks::ignore), "") << i << ", " << way;
        }
    }
    EXPECT_GT(cancelled, 50U);
}

INSTANTIATE_TEST_SUITE_P(All, DeterminismOfChoices, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
