#include "probe/probe.hpp"

#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/small_dataset/small_dataset.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace server::probe {
using namespace ciel;
namespace {

class probe_points : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<test::Folder>();
        test::write_small_dataset(folder->path() / "box.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }
    static std::unique_ptr<test::Folder> folder;
    std::shared_ptr<store::Dataset> dataset = store::Dataset::open(folder->path() / "box.ciel");
    const std::shared_ptr<const CellLocator> kept = store::LoadedDataset(dataset, 1U << 24).locator(0);
    const CellLocator& locator = *kept;
};
std::unique_ptr<test::Folder> probe_points::folder;

Vec3d world(const Vec3d& offset) {
    return {test::box_origin[0] + offset[0], test::box_origin[1] + offset[1], test::box_origin[2] + offset[2]};
}

TEST_F(probe_points, linear_fields_are_exact_and_holes_are_holes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.01, test::box_edge - 0.01);
    int inside_count = 0, hole_count = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d at{place(random), place(random), place(random)};
        const bool in_hole = std::all_of(at.begin(), at.end(), [](double x) { return x > 2 && x < 4; });
        const Probed probed = probe(*dataset, 1, locator, world(at));
        ++(in_hole ? hole_count : inside_count);
        ASSERT_EQ(probed.cell == none, in_hole) << at[0] << ' ' << at[1] << ' ' << at[2];
        if (in_hole) continue;
        EXPECT_NEAR(*probed.values.at("p"), test::pressure(at, 1), 1e-4);
        EXPECT_NEAR(*probed.values.at("U:x"), test::velocity(at)[0], 1e-4);
        EXPECT_NEAR(*probed.values.at("U:z"), test::velocity(at)[2], 1e-4);
        EXPECT_EQ(*probed.values.at("cell:q"), probed.cell); // the imported cell's id is its value
        EXPECT_FALSE(probed.values.at("late"));              // not written at this step
    }
    EXPECT_GT(hole_count, 50);
    EXPECT_GT(inside_count, 1000);
}

TEST_F(probe_points, outside_of_the_box_is_nothing) {
    for (const Vec3d at : {Vec3d{-0.1, 3, 3}, Vec3d{3, 6.1, 1}, Vec3d{1e30, 0, 0}}) {
        const Probed probed = probe(*dataset, 0, locator, world(at));
        EXPECT_EQ(probed.cell, none);
        EXPECT_TRUE(probed.values.empty());
    }
}

TEST_F(probe_points, a_vertex_is_its_own_nearest) {
    const FaceMeshView mesh = dataset->mesh_arrays().points(0, 0);
    for (Index vertex = 0; vertex < mesh.vertex_count(); vertex += 7) {
        const float* at = &mesh.positions.floats()[std::size_t{3} * vertex];
        const Probed probed = probe(*dataset, 0, locator, world({at[0], at[1], at[2]}));
        ASSERT_NE(probed.cell, none);
        EXPECT_EQ(probed.vertex, dataset->original_vertex(0)[vertex]);
    }
}

TEST(probe_vectors, of_cells_are_told_like_those_of_points) {
    const Assembled assembled = assemble(test::view(test::hexahedra({{1, 1, 1}})));
    const test::Folder scratch;
    store::Writer writer(scratch.path() / "m.ciel", {});
    writer.add_mesh(assembled.mesh, assembled.original_vertex, assembled.original_cell, {});
    const std::vector<float> velocity{3, 0, -4};
    const store::ArrayInfo info{"cell:U", store::Association::cell, 3, "m/s", ""};
    writer.add_step(0, 0, 0, std::vector<store::ArrayValues>{{info, velocity}});
    writer.finish();
    const auto dataset = store::Dataset::open(scratch.path() / "m.ciel");
    const Probed probed = probe(*dataset, 0, *store::LoadedDataset(dataset, 1U << 24).locator(0), {0.5, 0.5, 0.5});
    EXPECT_EQ(probed.values.at("cell:U:x"), 3);
    EXPECT_EQ(probed.values.at("cell:U:z"), -4);
    EXPECT_EQ(probed.values.at("cell:U:magnitude"), 5);
}

} // namespace
} // namespace server::probe
