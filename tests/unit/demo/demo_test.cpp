// The demo dataset has the properties that the README states.
#include "demo/demo.hpp"

#include "store/dataset.hpp"
#include "store/mesh_arrays.hpp"
#include "support/folder.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace server::demo {
using namespace ciel;
namespace {

class DemoTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        double last = 0;
        write_demo(*folder / "demo.ciel", false, 1, [&](double share, const char*) {
            EXPECT_GE(share, last);
            last = share;
        });
        EXPECT_EQ(last, 1);
        dataset = store::Dataset::open(*folder / "demo.ciel");
    }
    static void TearDownTestSuite() {
        dataset.reset();
        folder.reset();
    }

    // The numbered faces, with positions that can be read.
    static FaceMeshView faces() {
        FaceMeshView faces = dataset->mesh_arrays().numbered_faces(0, 0);
        const FaceMeshView points = dataset->mesh_arrays().points(0, 0);
        faces.positions = points.positions;
        faces.keep_alive = points.keep_alive;
        return faces;
    }
    static Ids group(std::string_view name) {
        for (const store::Group& each : dataset->groups(0))
            if (each.name == name) return each.ids;
        ADD_FAILURE() << "no group " << name;
        return {};
    }

    static std::unique_ptr<test::Folder> folder;
    static std::shared_ptr<store::Dataset> dataset;
};
std::unique_ptr<test::Folder> DemoTest::folder;
std::shared_ptr<store::Dataset> DemoTest::dataset;

TEST_F(DemoTest, HoldsAHundredThousandPolyhedraInOnePiece) {
    const store::MeshInfo& mesh = dataset->info().meshes.at(0);
    EXPECT_GE(mesh.cells_by_type.at("polyhedron"), 100'000U);
    EXPECT_GE(mesh.cells_by_type.at("hexahedron"), 100'000U);
    EXPECT_EQ(mesh.components, 1U);
    EXPECT_EQ(dataset->info().input_cells, mesh.cells);
    EXPECT_EQ(group("voronoi").size() + group("hexahedra").size(), mesh.cells);
    // Euler's formula for a solid with a hole through it and ball-shaped cells: V - E + F - C = 0.
    EXPECT_EQ(mesh.vertices + mesh.faces, mesh.edges + mesh.cells);
}

// Cells that do not match face to face would leave boundary faces inside. All boundary faces must be on the box or the
// cylinder.
TEST_F(DemoTest, BoundaryFacesAreOnNamedPatchesOnly) {
    const FaceMeshView mesh = faces();
    std::vector<int> patches(mesh.face_count());
    for (const store::Group& each : dataset->groups(0))
        if (each.of == store::Group::Of::faces)
            for (const Index face : each.ids) ++patches[face];
    for (Index face = 0; face < mesh.face_count(); ++face)
        ASSERT_EQ(patches[face], mesh.neighbour[face] == none ? 1 : 0) << "face " << face;
    for (const char* name : {"inlet", "outlet", "bottom", "top", "back", "front"})
        EXPECT_FALSE(group(name).empty()) << name;
    EXPECT_GT(group("cylinder").size(), 2000U);
    for (const Index face : group("cylinder"))
        for (const Index v : mesh.loop(face))
            ASSERT_NEAR(std::hypot(mesh.positions[3 * v], mesh.positions[3 * v + 1]), 1, 1e-5);
}

TEST_F(DemoTest, TheWallIsAPrismAroundTheCylinder) {
    const FaceMeshView mesh = faces();
    double volume = 0, wall = 0; // volume by the divergence theorem, as a sum over boundary faces
    std::vector<bool> on_wall(mesh.face_count());
    for (const Index face : group("cylinder")) on_wall[face] = true;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] != none) continue;
        const auto loop = mesh.loop(face);
        for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
            const auto p = [&](std::size_t corner, std::size_t axis) {
                return double{mesh.positions[3 * loop[corner] + axis]};
            };
            const Vec3d a{p(k, 0) - p(0, 0), p(k, 1) - p(0, 1), p(k, 2) - p(0, 2)},
                b{p(k + 1, 0) - p(0, 0), p(k + 1, 1) - p(0, 1), p(k + 1, 2) - p(0, 2)};
            const Vec3d n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
            volume += (p(0, 0) * n[0] + p(0, 1) * n[1] + p(0, 2) * n[2]) / 6;
            if (on_wall[face]) wall += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
        }
    }
    const auto& b = dataset->info().meshes[0].bounds;
    const double height = b[5] - b[4];
    constexpr int sides = 56;
    const double prism = sides / 2.0 * std::sin(2 * std::numbers::pi / sides);
    EXPECT_NEAR(volume, ((b[1] - b[0]) * (b[3] - b[2]) - prism) * height, 1e-3);
    EXPECT_NEAR(wall, 2 * sides * std::sin(std::numbers::pi / sides) * height, 1e-3);
}

TEST_F(DemoTest, TwentyStepsOfAFlowThatSticksToTheWall) {
    ASSERT_GE(dataset->steps().size(), 20U);
    const FaceMeshView mesh = faces();
    for (std::size_t step = 0; step < dataset->steps().size(); ++step) {
        const auto velocity = dataset->values("U", step);
        double highest = 0;
        for (const Index face : group("cylinder"))
            for (const Index v : mesh.loop(face))
                for (std::size_t c = 0; c < 3; ++c) highest = std::max(highest, std::abs(velocity[3 * v + c]));
        EXPECT_EQ(highest, 0) << "step " << step;
        const auto& arrays = dataset->steps()[step].arrays;
        EXPECT_GE(arrays.at("tracer").range[0], 0);
        EXPECT_LE(arrays.at("tracer").range[1], 1);
        EXPECT_GT(arrays.at("vorticity").range[1], 5);
        EXPECT_LT(arrays.at("vorticity").range[0], -5);
        for (const auto& [name, array] : arrays) EXPECT_EQ(array.invalid, 0U) << name;
    }
    EXPECT_EQ(dataset->find("U")->components, 3);
    EXPECT_THAT(dataset->info().notes.at(0), testing::HasSubstr("Chaos 3, 555"));
}

TEST_F(DemoTest, TheFlowVariesOverTimeAndSpan) {
    const auto first = dataset->values("vorticity", 0),
               half = dataset->values("vorticity", dataset->steps().size() / 2);
    double difference = 0;
    for (std::size_t i = 0; i < first.size(); ++i) difference += std::abs(first[i] - half[i]);
    EXPECT_GT(difference / static_cast<double>(first.size()), 1);
}

std::vector<std::string> group_names(const store::Dataset& dataset) {
    std::vector<std::string> names;
    for (const store::Group& each : dataset.groups(0)) {
        EXPECT_FALSE(each.ids.empty()) << each.name;
        names.emplace_back(each.name);
    }
    return names;
}

// Expects equal time and arrays, and ranges of similar width.
void expect_alike(const store::Step& coarse, const store::Step& whole) {
    EXPECT_EQ(coarse.time, whole.time);
    ASSERT_EQ(coarse.arrays.size(), whole.arrays.size());
    for (const auto& [name, array] : whole.arrays) {
        ASSERT_TRUE(coarse.arrays.contains(name)) << name;
        const auto &few = coarse.arrays.at(name).range, &many = array.range;
        EXPECT_NEAR((few[1] - few[0]) / (many[1] - many[0]), 1, 0.25) << name << " at " << whole.time;
    }
}

// A coarse demo dataset can replace the full one in tests that do not depend on the number of cells.
TEST_F(DemoTest, ACoarseOneHasTheSameNamesTimesAndKindsOfCellsInAlmostTheSameBox) {
    const store::MeshInfo& large = dataset->info().meshes.at(0);
    for (int coarseness = 2; coarseness <= most_coarseness; ++coarseness) {
        SCOPED_TRACE(coarseness);
        const test::Folder place;
        write_demo(place / "coarse.ciel", false, coarseness, [](double, const char*) {});
        const auto coarse = store::Dataset::open(place / "coarse.ciel");
        const store::MeshInfo& small = coarse->info().meshes.at(0);
        EXPECT_EQ(small.components, 1U);
        EXPECT_EQ(small.vertices + small.faces, small.edges + small.cells);
        EXPECT_EQ(small.cells_by_type.size(), large.cells_by_type.size());
        for (const auto& [type, cells] : large.cells_by_type) {
            const double expected = static_cast<double>(cells) / (coarseness * coarseness * coarseness);
            EXPECT_NEAR(static_cast<double>(small.cells_by_type.at(type)) / expected, 1, 0.25) << type;
        }
        for (std::size_t side = 0; side < 6; ++side) EXPECT_NEAR(small.bounds[side], large.bounds[side], 1) << side;
        EXPECT_EQ(group_names(*coarse), group_names(*dataset));
        ASSERT_EQ(coarse->steps().size(), dataset->steps().size());
        for (std::size_t step = 0; step < coarse->steps().size(); ++step)
            expect_alike(coarse->steps()[step], dataset->steps()[step]);
    }
}

} // namespace
} // namespace server::demo
