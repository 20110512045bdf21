// A dataset written again holds the same, with blocks and ranges.
#include "store/rewrite.hpp"

#include "store/writer.hpp"
#include "support/store_box/box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;

// As an earlier version wrote it: without blocks and ranges.
void make_old(const fs::path& dataset) {
    std::vector<fs::path> removed;
    for (const auto& entry : fs::recursive_directory_iterator(dataset))
        if (entry.path().filename() == "blocks" || entry.path().filename() == "ranges") removed.push_back(entry.path());
    for (const fs::path& path : removed) fs::remove_all(path);
}

class RewriteTest : public testing::Test {
protected:
    RewriteTest() {
        test::write_box(old, test::box(3, 2, 2));
        Writer writer = Writer::append(old);
        std::vector<float> moved(writer.before()->points(0, 0).positions.begin(),
                                 writer.before()->points(0, 0).positions.end());
        for (float& x : moved) x += 0.25F;
        const std::size_t set = writer.add_coordinates(0, moved);
        const std::vector<float> p(36, 4);
        writer.add_step(2, 0, set, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
        writer.finish();
        make_old(old);
    }

    test::Folder scratch;
    fs::path old = scratch / "old.ciel", made = scratch / "new.ciel";
    std::vector<double> shares;
    const std::function<void(double)> progress = [this](double share) { shares.push_back(share); };
};

void expect_same(const Dataset& a, const Dataset& b) {
    const FaceMeshView mesh = a.mesh(0, 0), other = b.mesh(0, 0);
    EXPECT_THAT(other.face_vertex, ElementsAreArray(mesh.face_vertex));
    EXPECT_THAT(other.owner, ElementsAreArray(mesh.owner));
    EXPECT_THAT(other.positions, ElementsAreArray(mesh.positions));
    EXPECT_THAT(b.points(0, 1).positions, ElementsAreArray(a.points(0, 1).positions));
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

TEST_F(RewriteTest, SaysWhichArraysWereNeverExtracted) {
    const fs::path marker = old / "steps.json";
    std::string text = test::read_file(marker);
    const std::size_t at =
        text.find("\"p\": {") != std::string::npos ? text.find("\"p\": {") + 6 : text.find("\"p\":{") + 5;
    text.insert(at, "\"lazy\": true, ");
    test::overwrite_file(marker, text);
    fs::remove(old / "meshes/0/arrays/p/0.0");
    const auto left_out = rewrite(old, made, false, progress);
    ASSERT_EQ(left_out.size(), 1U);
    EXPECT_THAT(left_out[0], testing::HasSubstr("array 'p' is not yet extracted"));
    const auto dataset = Dataset::open(made);
    EXPECT_FALSE(dataset->steps()[0].arrays.contains("p"));
    EXPECT_TRUE(dataset->steps()[0].arrays.contains("U"));
    EXPECT_THAT(dataset->info().notes.back(), testing::HasSubstr("An array was left out"));
}

} // namespace
} // namespace ciel::store
