// A dataset that is written again has the same content, and has blocks and ranges.
#include "store/rewrite.hpp"

#include "ciel/mesh_faces.hpp"
#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"
#include "support/meshes.hpp"
#include "support/store_box/box.hpp"
#include "support/store_box/format_1.hpp"
#include "support/views.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;

class RewriteTest : public testing::Test {
protected:
    RewriteTest() {
        test::write_box(old, test::box(3, 2, 2));
        Writer writer = Writer::append(old);
        std::vector<float> moved(writer.before()->mesh_arrays().points(0, 0).positions.begin(),
                                 writer.before()->mesh_arrays().points(0, 0).positions.end());
        for (float& x : moved) x += 0.25F;
        const std::size_t set = writer.add_coordinates(0, moved);
        const std::vector<float> p(36, 4);
        writer.add_step(2, 0, set, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
        writer.finish();
        test::make_format_1(old, test::box(3, 2, 2));
        test::remove_blocks(old);
    }

    test::Folder scratch;
    fs::path old = scratch / "old.ciel", made = scratch / "new.ciel";
    std::vector<double> shares;
    const std::function<void(double)> progress = [this](double share) { shares.push_back(share); };
};

void expect_same(const Dataset& a, const Dataset& b) {
    const FaceMeshView mesh = a.mesh_arrays().all_faces(0, 0), other = b.mesh_arrays().all_faces(0, 0);
    EXPECT_TRUE(same_cells(Topology(mesh), Topology(other)));
    EXPECT_THAT(other.positions, ElementsAreArray(mesh.positions));
    EXPECT_THAT(b.mesh_arrays().points(0, 1).positions, ElementsAreArray(a.mesh_arrays().points(0, 1).positions));
    EXPECT_THAT(b.original_cell(0), ElementsAreArray(a.original_cell(0)));
    EXPECT_EQ(b.info().source, a.info().source);
    EXPECT_EQ(b.info().meshes[0].bounds, a.info().meshes[0].bounds);
    ASSERT_EQ(b.groups(0).size(), a.groups(0).size());
    for (std::size_t i = 0; i < a.groups(0).size(); ++i)
        EXPECT_THAT(b.groups(0)[i].ids, ElementsAreArray(a.groups(0)[i].ids));
    ASSERT_EQ(b.steps().size(), a.steps().size());
    for (std::size_t step = 0; step < a.steps().size(); ++step) {
        EXPECT_EQ(b.steps()[step].time, a.steps()[step].time);
        EXPECT_EQ(b.steps()[step].coordinates, a.steps()[step].coordinates);
        ASSERT_EQ(b.steps()[step].arrays.size(), a.steps()[step].arrays.size());
        for (const auto& [name, array] : a.steps()[step].arrays) {
            EXPECT_THAT(b.values(name, step), ElementsAreArray(a.values(name, step))) << name;
            EXPECT_EQ(b.steps()[step].arrays.at(name).range, array.range);
        }
    }
}

TEST_F(RewriteTest, HoldsTheSameAndHasBlocks) {
    ASSERT_FALSE(Dataset::open(old)->block_boxes(0, 0));
    EXPECT_TRUE(is_dataset(old));
    EXPECT_FALSE(is_dataset(scratch.path()));
    EXPECT_TRUE(rewrite(old, made, false, progress).empty());
    const auto dataset = Dataset::open(made);
    EXPECT_NO_THROW(dataset->verify());
    expect_same(*Dataset::open(old), *dataset);
    for (const std::size_t set : {0U, 1U}) EXPECT_TRUE(dataset->block_boxes(0, set)) << set;
    EXPECT_TRUE(dataset->block_ranges({"p", std::nullopt, false}, 0));
    EXPECT_NE(dataset->info().id, Dataset::open(old)->info().id);
    EXPECT_THAT(shares, testing::ElementsAre(0, 0.2, 0.4, 0.6, 0.8)) << "one mesh and four steps";
}

// Faces of groups and values on boundary faces keep their numbers, also where blocks and face lists order faces
// differently, and in meshes with collapsed cells.
TEST_F(RewriteTest, KeepsTheNumbersOfFaces) {
    for (const test::NamedMesh& named : test::all_meshes()) {
        const Assembled assembled = assemble(test::view(named.make()));
        const FaceMesh& mesh = assembled.mesh;
        std::vector<Index> on, inside;
        for (Index face = 0; face < mesh.owner.size(); ++face)
            (mesh.neighbour[face] == none ? on : inside).push_back(face);
        if (inside.size() < 5) continue;
        std::vector<float> values(on.size());
        std::iota(values.begin(), values.end(), 0.0F);
        const fs::path first = scratch / (std::string(named.name) + ".ciel"),
                       second = scratch / (std::string(named.name) + "2.ciel");
        Writer writer(first, {});
        writer.add_mesh(mesh, assembled.original_vertex, assembled.original_cell,
                        std::vector<NamedGroup>{{Group::Of::faces, "baffle", {inside[4], on[2], inside[1]}},
                                                {Group::Of::cells, "zone", {0}}});
        writer.add_step(0, 0, 0,
                        std::vector<ArrayValues>{{{"patch:p", Association::boundary_face, 1, "", ""}, values}});
        writer.finish();
        (void)rewrite(first, second, false, [](double) {});
        const auto a = Dataset::open(first), b = Dataset::open(second);
        const FaceMeshView faces = a->mesh_arrays().numbered_faces(0, 0), again = b->mesh_arrays().numbered_faces(0, 0);
        EXPECT_THAT(again.owner, ElementsAreArray(faces.owner)) << named.name;
        EXPECT_THAT(again.neighbour, ElementsAreArray(faces.neighbour)) << named.name;
        for (Index face = 0; face < faces.face_count(); ++face) {
            const std::multiset<Index> vertices(faces.loop(face).begin(), faces.loop(face).end());
            EXPECT_EQ(std::multiset<Index>(again.loop(face).begin(), again.loop(face).end()), vertices) << named.name;
        }
        for (std::size_t i = 0; i < 2; ++i) EXPECT_THAT(b->groups(0)[i].ids, ElementsAreArray(a->groups(0)[i].ids));
        EXPECT_THAT(b->values("patch:p", 0), ElementsAreArray(values));
        EXPECT_NO_THROW(b->verify());
    }
}

TEST_F(RewriteTest, OfFormat1WithBlocksHoldsTheSame) {
    const fs::path with_blocks = scratch / "blocks.ciel";
    test::write_box(with_blocks, test::box(3, 2, 2));
    const auto before = Dataset::open(with_blocks);
    const std::vector<Index> wall(before->groups(0)[0].ids.begin(), before->groups(0)[0].ids.end());
    test::make_format_1(with_blocks, test::box(3, 2, 2));
    (void)rewrite(with_blocks, made, false, progress);
    EXPECT_THAT(Dataset::open(made)->groups(0)[0].ids, ElementsAreArray(wall));
    EXPECT_EQ(Dataset::open(made)->info().format_version, 2);
}

TEST_F(RewriteTest, AMeshThatIsAddedMakesItFormat2) {
    {
        Writer writer = Writer::append(old);
        const std::size_t mesh = writer.add_mesh(test::box(1, 1, 1), test::identity(8), test::identity(1), {});
        writer.add_step(3, mesh, 0, std::vector<ArrayValues>{});
        writer.finish();
    }
    const auto dataset = Dataset::open(old);
    EXPECT_EQ(dataset->info().format_version, 2);
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_EQ(dataset->mesh_arrays().boundary(0, 0).face_count(), 32U);
    EXPECT_EQ(dataset->mesh_arrays().boundary(1, 0).face_count(), 6U);
}

TEST_F(RewriteTest, MayReplaceWhatItReads) {
    const auto before = Dataset::open(old);
    EXPECT_THROW((void)rewrite(old, old, false, progress), Error) << "not unless asked";
    (void)rewrite(old, old, true, progress);
    expect_same(*before, *Dataset::open(old));
    EXPECT_TRUE(Dataset::open(old)->block_boxes(0, 0));
}

TEST_F(RewriteTest, LeavesNothingWhenItIsCancelledOrTheDatasetIsDamaged) {
    EXPECT_THROW((void)rewrite(old, made, false, [](double share) { share > 0.5 ? throw Error("enough") : void(); }),
                 Error);
    EXPECT_FALSE(fs::exists(made));
    test::overwrite_file(old / "meshes/0/arrays/p/0.0", std::string(36 * 4, 'x'));
    EXPECT_THROW((void)rewrite(old, made, false, progress), Error);
    EXPECT_FALSE(fs::exists(made));
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1) << "the old dataset alone";
}

TEST_F(RewriteTest, SaysWhichArraysWereNeverRead) {
    const fs::path marker = old / "steps.json";
    std::string text = test::read_file(marker);
    const std::size_t at =
        text.find("\"p\": {") != std::string::npos ? text.find("\"p\": {") + 6 : text.find("\"p\":{") + 5;
    text.insert(at, "\"lazy\": true, ");
    test::overwrite_file(marker, text);
    fs::remove(old / "meshes/0/arrays/p/0.0");
    const auto left_out = rewrite(old, made, false, progress);
    ASSERT_EQ(left_out.size(), 1U);
    EXPECT_THAT(left_out[0], testing::HasSubstr("array 'p' has not been read from its source yet"));
    const auto dataset = Dataset::open(made);
    EXPECT_FALSE(dataset->steps()[0].arrays.contains("p"));
    EXPECT_TRUE(dataset->steps()[0].arrays.contains("U"));
    EXPECT_THAT(dataset->info().notes.back(), testing::HasSubstr("An array was left out"));
}

} // namespace
} // namespace server::store
