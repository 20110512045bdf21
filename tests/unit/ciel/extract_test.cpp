#include "support/kept.hpp"
#include "unit/ciel/equal_surfaces.hpp"
#include "unit/ciel/meshes.hpp"

#include "ciel/extract.hpp"
#include "support/thread_count.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace ciel::test {
namespace {

std::vector<float> random_field(std::size_t size, unsigned seed, int levels) {
    std::mt19937 random(seed);
    std::vector<float> out(size);
    for (float& v : out) // few distinct levels give ties, plateaus and values equal to the iso-value
        v = levels > 0 ? static_cast<float>(random() % static_cast<unsigned>(levels))
                       : std::uniform_real_distribution<float>(0, 4)(random);
    return out;
}

// Pairs of vertices that share a boundary face. Segments between such pairs may lie on the boundary.
std::set<std::pair<Index, Index>> boundary_edges(const FaceMesh& mesh) {
    std::set<std::pair<Index, Index>> out;
    for (Index f = 0; f < mesh.owner.size(); ++f) {
        const auto loop = mesh.view().loop(f);
        for (std::size_t i = 0; mesh.neighbour[f] == none && i < loop.size(); ++i)
            out.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
    }
    return out;
}

// Each segment occurs once in each direction, except when both ends are on the mesh's boundary.
void expect_closed(const FaceMesh& mesh, const Surface& surface) {
    std::map<std::pair<Index, Index>, int> balance;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const Index begin = surface.polygon_offset[i], end = surface.polygon_offset[i + 1];
        ASSERT_GE(end - begin, 3U);
        for (Index k = begin; k < end; ++k) {
            const Index a = surface.polygon_vertex[k], b = surface.polygon_vertex[k + 1 == end ? begin : k + 1];
            ASSERT_NE(a, b);
            balance[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    }
    const auto boundary = boundary_edges(mesh);
    const auto on_boundary = [&](Index p) { return boundary.contains({surface.points[p].a, surface.points[p].b}); };
    for (const auto& [segment, sum] : balance)
        EXPECT_TRUE(sum == 0 || (on_boundary(segment.first) && on_boundary(segment.second)));
}

void expect_sound(const FaceMesh& mesh, std::span<const float> values, double nu, const Surface& surface) {
    std::set<Index> used(surface.polygon_vertex.begin(), surface.polygon_vertex.end());
    EXPECT_EQ(used.size(), surface.points.size());
    std::set<std::pair<Index, Index>> edges;
    for (const EdgePoint& p : surface.points) {
        ASSERT_LT(p.a, p.b);
        ASSERT_NE(values[p.a] >= nu, values[p.b] >= nu);
        ASSERT_TRUE(edges.emplace(p.a, p.b).second);
    }
    std::set<std::pair<Index, Index>> expected;
    for (Index f = 0; f < mesh.owner.size(); ++f) {
        const auto loop = mesh.view().loop(f);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Index a = loop[i], b = loop[(i + 1) % loop.size()];
            if ((values[a] >= nu) != (values[b] >= nu)) expected.insert(std::minmax(a, b));
        }
    }
    EXPECT_EQ(edges, expected);
    EXPECT_TRUE(std::ranges::is_sorted(surface.polygon_cell));
    Index polygons = 0;
    for (const Surface::Chunk& chunk : surface.chunks) {
        EXPECT_EQ(chunk.polygon_begin, polygons);
        polygons = chunk.polygon_end;
    }
    EXPECT_EQ(polygons, surface.polygon_cell.size());
    expect_closed(mesh, surface);
}

double area_towards(const Surface& surface, std::size_t axis) {
    double sum = 0;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const Index begin = surface.polygon_offset[i], end = surface.polygon_offset[i + 1];
        for (Index k = begin; k < end; ++k) {
            const Vec3f &a = surface.positions[surface.polygon_vertex[k]],
                        &b = surface.positions[surface.polygon_vertex[k + 1 == end ? begin : k + 1]];
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            sum += 0.5 * (static_cast<double>(a[u]) * b[v] - static_cast<double>(a[v]) * b[u]);
        }
    }
    return sum;
}

TEST(Extract, IsClosedAndTheSameForAnyAlgorithmHistoryBlockSizeAndThreads) {
    for (const NamedMesh& m : all_meshes()) {
        SCOPED_TRACE(m.name);
        const FaceMeshView view = kept(m.mesh.view());
        const Topology whole(view, {1000}), split(view, {3});
        Query reference(whole, view), signatures(split, view), propagation(split, view, Algorithm::propagation);
        for (unsigned round = 0; round < 6; ++round) {
            const int levels[] = {0, 5, 2, 1, 0, 3};
            const auto values = random_field(view.vertex_count(), round, levels[round]);
            const Field on_whole(whole, values, kept_by_test), on_split(split, values, kept_by_test);
            reference.set_field(on_whole);
            signatures.set_field(on_split);
            propagation.set_field(on_split);
            for (const double nu : {0.5, 1.0, 1.5, 3.5, 3.0, 0.2, 0.0, 2.0, 2.0, 99.0, -1.0, 1.0, 4.0}) {
                SCOPED_TRACE("round " + std::to_string(round) + ", nu " + std::to_string(nu));
                Surface a, b, c;
                {
                    const ThreadCount one(1);
                    ASSERT_TRUE(reference.extract(nu, true, a));
                }
                ASSERT_TRUE(signatures.extract(nu, true, b));
                ASSERT_TRUE(propagation.extract(nu, true, c));
                expect_equal(a, b);
                expect_equal(b, c);
                expect_sound(m.mesh, values, nu, a);
                if (testing::Test::HasFailure()) return;
            }
        }
    }
}

TEST(Extract, CutsASliceOfExactArea) {
    for (const auto& [mesh, area] : {std::pair{hexahedra(4, 3, 2), 6.0}, std::pair{tetrahedra(4, 3, 2), 6.0},
                                     std::pair{hanging_nodes(), 4.0}, std::pair{hollow_box(), 9.0 - 1.0}}) {
        const FaceMesh stored = mesh.assembled().mesh;
        const Topology topology(stored.view());
        const auto values = plane_distance(stored.view(), {0.25, 0, 0}, {1, 0, 0});
        const Field field(topology, values, kept_by_test);
        Query query(topology, kept(stored.view()));
        query.set_field(field);
        Surface surface;
        ASSERT_TRUE(query.extract(1.25, true, surface));
        EXPECT_NEAR(area_towards(surface, 0), area, 1e-5); // positive: the normals point to higher values
        EXPECT_EQ(surface.positions.size(), surface.points.size());
        EXPECT_EQ(surface.normals.size(), surface.points.size());
        for (const Vec3f& normal : surface.normals) EXPECT_NEAR(normal[0], 1, 1e-6);
        for (const Vec3f& position : surface.positions) EXPECT_NEAR(position[0], 1.5, 1e-6);
    }
}

TEST(Extract, GivesACellTwoPolygonsAndCutsTheHighSideOff) {
    const FaceMesh mesh = hexahedra(1, 1, 1).assembled().mesh;
    const Topology topology(mesh.view());
    std::vector<float> values(8, 0);
    for (Index v = 0; v < 8; ++v) { // two opposite corners of one face are above the iso-value
        const float* p = &mesh.positions[3 * std::size_t{v}];
        values[v] = p[2] == 0 && p[0] == p[1] ? 1.0F : -p[2] - 0.1F * p[0] - 0.01F * p[1];
    }
    const Field field(topology, values, kept_by_test);
    Query query(topology, kept(mesh.view()));
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0.5, false, surface));
    EXPECT_EQ(surface.polygon_offset, (std::vector<Index>{0, 3, 6}));
    EXPECT_TRUE(surface.normals.empty());
    EXPECT_EQ(count_ambiguous_faces(topology, mesh.view(), values), 1U);
}

TEST(Extract, PassesOverCellsThatTouchAVertexWithoutAValue) {
    for (const float hole : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                             -std::numeric_limits<float>::infinity()})
        for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
            const FaceMesh mesh = hexahedra(5, 5, 1).assembled().mesh;
            const Topology topology(mesh.view(), {4});
            auto values = plane_distance(mesh.view(), {}, {0, 0, 1});
            const Field whole(topology, values, kept_by_test);
            auto holed = values;
            for (Index v = 0; v < holed.size(); ++v) {
                const float* p = &mesh.positions[3 * std::size_t{v}];
                if (p[0] == 2 && p[1] == 3) holed[v] = hole;
            }
            const Field field(topology, holed, kept_by_test);
            EXPECT_EQ(field.range(), (std::array<double, 2>{0, 1}));
            Query query(topology, kept(mesh.view()), algorithm);
            Surface surface;
            query.set_field(whole);
            ASSERT_TRUE(query.extract(0.5, true, surface));
            EXPECT_EQ(surface.polygon_cell.size(), 25U);
            query.set_field(field);
            ASSERT_TRUE(query.extract(0.5, true, surface));
            EXPECT_EQ(surface.polygon_cell.size(), 21U);
            EXPECT_EQ(surface.points.size(), 35U);
            EXPECT_EQ(surface.normals.size(), 35U);
            for (const Vec3f& normal : surface.normals) EXPECT_NEAR(normal[2], 1, 1e-5);
            query.set_field(whole);
            ASSERT_TRUE(query.extract(0.5, true, surface));
            EXPECT_EQ(surface.polygon_cell.size(), 25U);
        }
}

TEST(Extract, StopsWhenAskedAndGoesOnAfterwards) {
    const FaceMesh mesh = hexahedra(8, 8, 8).assembled().mesh;
    const Topology topology(mesh.view(), {16});
    const auto values = random_field(mesh.view().vertex_count(), 3, 0);
    const Field field(topology, values, kept_by_test);
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        Query query(topology, kept(mesh.view()), algorithm), fresh(topology, kept(mesh.view()));
        query.set_field(field);
        fresh.set_field(field);
        Surface surface, expected;
        std::stop_source stop;
        stop.request_stop();
        ASSERT_TRUE(query.extract(1, true, surface));
        EXPECT_FALSE(query.extract(3, true, surface, stop.get_token()));
        ASSERT_TRUE(query.extract(2, true, surface));
        ASSERT_TRUE(fresh.extract(2, true, expected));
        expect_equal(surface, expected);
    }
}

TEST(Extract, TakesNotANumberAndInfinityAsValues) {
    const FaceMesh mesh = hexahedra(3, 3, 3).assembled().mesh;
    const Topology topology(mesh.view());
    const auto values = plane_distance(mesh.view(), {}, {1, 1, 1});
    const Field field(topology, values, kept_by_test);
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        Query query(topology, kept(mesh.view()), algorithm);
        query.set_field(field);
        Surface surface;
        for (const double nu : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300, -1e300}) {
            ASSERT_TRUE(query.extract(nu, true, surface));
            EXPECT_EQ(surface.polygon_offset, (std::vector<Index>{0}));
            EXPECT_TRUE(surface.points.empty());
        }
        ASSERT_TRUE(query.extract(4.5, true, surface));
        EXPECT_FALSE(surface.points.empty());
    }
}

TEST(Extract, RefusesWhatDoesNotBelongTogether) {
    const FaceMesh mesh = hexahedra(2, 1, 1).assembled().mesh, other = hexahedra(3, 1, 1).assembled().mesh;
    const Topology topology(mesh.view()), another(mesh.view());
    const std::vector<float> values(12);
    const Field field(another, values, kept_by_test);
    EXPECT_THROW(Query(topology, kept(other.view())), Error);
    EXPECT_THROW(Query(topology, kept(mesh.view())).set_field(field), Error);
    Surface surface;
    EXPECT_THROW(Query(topology, kept(mesh.view())).extract(0, false, surface), Error);
    EXPECT_THROW(Field(topology, std::span(values).first(11), kept_by_test), Error);
}

TEST(Extract, SeriesGivesEachSurfaceInOrder) {
    const FaceMesh mesh = hexahedra(4, 4, 4).assembled().mesh;
    const Topology topology(mesh.view());
    const auto values = plane_distance(mesh.view(), {}, {0, 0, 1});
    const Field field(topology, values, kept_by_test);
    Query query(topology, kept(mesh.view()));
    query.set_field(field);
    std::vector<Surface> kept;
    const double nus[] = {3.5, 0.5, 2.5};
    ASSERT_TRUE(extract_series(query, nus, false, [&](double, Surface&& s) { kept.push_back(std::move(s)); }));
    ASSERT_EQ(kept.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(kept[i].positions.at(0)[2], static_cast<float>(nus[i]));
}

TEST(Field, HasTheMinimaOfTheOrderByValueAndId) {
    const FaceMesh mesh = hexahedra(6, 6, 6).assembled().mesh;
    const Topology topology(mesh.view(), {10});
    for (const int levels : {0, 2, 4, 1}) {
        auto values = random_field(mesh.view().vertex_count(), 5, levels);
        values[17] = std::numeric_limits<float>::quiet_NaN();
        std::vector<std::uint8_t> minimum(values.size(), 1);
        const auto below = [&](Index a, Index b) { return values[a] < values[b] || (values[a] == values[b] && a < b); };
        for (Index f = 0; f < mesh.owner.size(); ++f) {
            const auto loop = mesh.view().loop(f);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Index a = loop[i], b = loop[(i + 1) % loop.size()];
                if (below(a, b)) minimum[b] = 0;
                if (below(b, a)) minimum[a] = 0;
            }
        }
        minimum[17] = 0;
        std::vector<Index> expected;
        for (Index v = 0; v < minimum.size(); ++v)
            if (minimum[v]) expected.push_back(v);
        std::ranges::sort(expected, below);
        const Field field(topology, values, kept_by_test);
        EXPECT_THAT(field.sorted_minima(), testing::ElementsAreArray(expected));
    }
}

TEST(Gradient, IsExactForALinearFieldFarFromTheOrigin) {
    for (NamedMesh& m : all_meshes()) {
        SCOPED_TRACE(m.name);
        for (std::size_t i = 0; i < m.mesh.positions.size(); ++i) m.mesh.positions[i] += 1000;
        std::vector<float> values;
        for (std::size_t i = 0; i < m.mesh.positions.size(); i += 3)
            values.push_back(2 * (m.mesh.positions[i] - 1000) - 3 * (m.mesh.positions[i + 1] - 1000) +
                             (m.mesh.positions[i + 2] - 1000));
        const std::vector<Vec3f> gradients = vertex_gradients(m.mesh.view(), values);
        EXPECT_EQ(gradients.size(), values.size());
        for (const Vec3f& g : gradients) {
            EXPECT_NEAR(g[0], 2, 2e-3);
            EXPECT_NEAR(g[1], -3, 2e-3);
            EXPECT_NEAR(g[2], 1, 2e-3);
        }
    }
}

TEST(Gradient, NormalsFallBackOnPolygonsWhereThereIsNone) {
    const FaceMesh mesh = hexahedra(1, 1, 1).assembled().mesh;
    const Topology topology(mesh.view());
    // `flat`: a saddle whose fitted gradient is zero. `faint`: a gradient whose square underflows float32.
    std::vector<float> flat(8), faint(8);
    for (Index v = 0; v < 8; ++v) {
        const float* p = &mesh.positions[3 * std::size_t{v}];
        flat[v] = (p[0] + p[1] + p[2] == 1 || p[0] + p[1] + p[2] == 3) ? 1.0F : -1.0F;
        faint[v] = p[2] * 1e-30F;
    }
    const Field saddle(topology, flat, kept_by_test), slope(topology, faint, kept_by_test);
    Query query(topology, kept(mesh.view()));
    Surface surface;
    for (const auto& [field, nu, points] : {std::tuple{&saddle, 0.0, 12U}, std::tuple{&slope, 5e-31, 4U}}) {
        query.set_field(*field);
        ASSERT_TRUE(query.extract(nu, true, surface));
        ASSERT_EQ(surface.normals.size(), points);
        for (const Vec3f& n : surface.normals) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
    }
}

TEST(Triangulate, CoversEachPolygonOnceAlsoWhereItIsNotConvex) {
    Surface surface;
    surface.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5F, 0}, {0, 2, 0}, {5, 5, 5}};
    surface.points.resize(6);
    surface.polygon_offset = {0, 5, 8, 12};
    surface.polygon_vertex = {0, 1, 2, 3, 4, 0, 1, 1, 0, 5, 0, 5};
    surface.polygon_cell = {0, 1, 2};
    const auto triangles = triangulate(surface);
    ASSERT_EQ(triangles.size(), 9U);
    double area = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
        const auto &a = surface.positions[triangles[t]], &b = surface.positions[triangles[t + 1]],
                   &c = surface.positions[triangles[t + 2]];
        const double part = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        EXPECT_GT(part, 0);
        area += part;
    }
    EXPECT_NEAR(area, 4 - 1.5, 1e-6);
}

TEST(Interpolate, MixesAnyNumberOfComponents) {
    const EdgePoint points[] = {{0, 1, 0.25F}, {1, 2, 1}};
    const float values[] = {0, 10, 4, 20, 6, 40};
    std::vector<float> out(4);
    interpolate(points, values, 2, out);
    EXPECT_THAT(out, testing::ElementsAre(1, 12.5F, 6, 40));
    EXPECT_THROW(interpolate(points, values, 2, std::span(out).first(3)), Error);
}

} // namespace
} // namespace ciel::test
