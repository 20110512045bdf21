// The test meshes have the properties that other tests rely on.
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace ciel::test {
namespace {

class Generators : public testing::TestWithParam<NamedMesh> {};

TEST_P(Generators, CellsAreClosedAndWoundOutwards) {
    const Polyhedra mesh = GetParam().make();
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        std::map<std::pair<Id, Id>, int> balance;
        for (const Loop& loop : mesh.loops(c)) {
            ASSERT_GE(loop.size(), 3U) << "cell " << c;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Id u = loop[i], v = loop[(i + 1) % loop.size()];
                if (u != v) balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
            }
        }
        for (auto [edge, count] : balance) ASSERT_EQ(count, 0) << "cell " << c;
        EXPECT_GT(signed_volume(mesh, c), 0) << "cell " << c;
    }
}

TEST_P(Generators, RepeatedIdsAreDeclared) {
    const Polyhedra mesh = GetParam().make();
    bool repeated = false;
    for (std::uint64_t f = 0; f < mesh.face_count(); ++f) {
        const std::set<Id> distinct(mesh.face(f).begin(), mesh.face(f).end());
        repeated = repeated || distinct.size() < mesh.face(f).size();
    }
    EXPECT_EQ(repeated, GetParam().has_repeated_ids);
}

INSTANTIATE_TEST_SUITE_P(All, Generators, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// Maps the number of occurrences of a face (1 on the boundary, 2 inside) to the number of such faces.
std::map<std::size_t, std::size_t> face_uses(const Polyhedra& mesh) {
    std::map<Loop, std::size_t> uses;
    for (std::uint64_t f = 0; f < mesh.face_count(); ++f) {
        Loop key(mesh.face(f).begin(), mesh.face(f).end());
        std::sort(key.begin(), key.end());
        ++uses[key];
    }
    std::map<std::size_t, std::size_t> histogram;
    for (const auto& [key, count] : uses) ++histogram[count];
    return histogram;
}

using Histogram = std::map<std::size_t, std::size_t>;

TEST(GeneratorCounts, HexahedraMatchTheClosedForm) {
    EXPECT_EQ(face_uses(hexahedra({{3, 4, 5}})), (Histogram{{1, 94}, {2, 133}}));
}

TEST(GeneratorCounts, TetrahedraMatchTheClosedForm) {
    EXPECT_EQ(tetrahedra({{3, 4, 5}}).cell_count(), 360U);
    EXPECT_EQ(face_uses(tetrahedra({{3, 4, 5}})), (Histogram{{1, 188}, {2, 626}}));
    EXPECT_EQ(face_uses(five_tetrahedra({{3, 4, 5}})), (Histogram{{1, 188}, {2, 506}}));
}

// All vertices of a boundary face lie on the box. An inner face without a partner would violate this.
TEST(GeneratorCounts, VoronoiFacesMatchInside) {
    const Polyhedra mesh = voronoi(200, 3);
    EXPECT_EQ(mesh.cell_count(), 200U);
    std::map<Loop, int> uses;
    for (std::uint64_t f = 0; f < mesh.face_count(); ++f) {
        Loop key(mesh.face(f).begin(), mesh.face(f).end());
        std::sort(key.begin(), key.end());
        ++uses[key];
    }
    for (const auto& [key, count] : uses) {
        bool on_box = false;
        for (int d = 0; d < 3; ++d) {
            for (double side : {0.0, 1.0}) {
                on_box = on_box || std::all_of(key.begin(), key.end(),
                                               [&](Id v) { return std::abs(mesh.position(v)[d] - side) < 1e-6; });
            }
        }
        EXPECT_EQ(count, on_box ? 1 : 2);
    }
}

TEST(GeneratorCounts, TheZooHoldsEveryKindOfCell) {
    const Polyhedra mesh = zoo({{5, 4, 4}, 0, 14});
    const std::set<int> types(mesh.cell_types.begin(), mesh.cell_types.end());
    EXPECT_EQ(types, (std::set<int>{tetrahedron, hexahedron, wedge, pyramid, polyhedron}));
    for (auto [uses, count] : face_uses(mesh)) EXPECT_LE(uses, 2U);
}

TEST(GeneratorCounts, HangingNodesConformAndTJunctionsDoNot) {
    const Box box{{4, 4, 3}, 0, 18};
    EXPECT_GT(face_uses(t_junctions(box))[1], face_uses(hanging_nodes(box))[1]);
}

} // namespace
} // namespace ciel::test
