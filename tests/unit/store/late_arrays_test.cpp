// Arrays that are listed first and written later, in the dataset or in a folder of their own.
#include "store/files/files.hpp"
#include "store/late_writer.hpp"
#include "store/loaded.hpp"
#include "support/store_box/box.hpp"

#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;
using testing::HasSubstr;

const ArrayInfo p{"p", Association::point, 1, "Pa", ""}, q{"cell:q", Association::cell, 1, "", ""};

class LateArrays : public testing::Test {
protected:
    // Steps 0 and 3 are written, 1 and 2 are late.
    LateArrays() {
        Writer writer(directory, {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(test::box(2, 2, 2), test::identity(27), test::identity(8), {});
        const std::vector<ArrayInfo> both{p, q};
        add(writer, 0);
        for (const double time : {1, 2}) writer.add_late_step(time, 0, 0, both);
        add(writer, 3);
        writer.set_late(
            {{"/data/box.vtu"}, {{"array", {"p", "q"}}}, 1234567890123456789, {"", "xxh3:1", "xxh3:2", ""}, "a mesh"});
        writer.finish();
    }
    static void add(Writer& writer, std::size_t step) {
        const auto points = test::values_of(27, step), cells = test::values_of(8, step);
        writer.add_step(static_cast<double>(step), 0, 0, std::vector<ArrayValues>{{p, points}, {q, cells}});
    }
    static void fill(LateWriter& writer, std::size_t step) {
        const auto points = test::values_of(27, step), cells = test::values_of(8, step);
        writer.put(step, {p, points});
        writer.put(step, {q, cells});
        writer.end_step(step);
    }
    [[nodiscard]] std::shared_ptr<Dataset> open(const fs::path& folder = {}) const {
        return Dataset::open(directory, LackingRanges::computed, std::nullopt, folder);
    }

    const test::Folder scratch;
    fs::path directory = scratch / "box.ciel", elsewhere = scratch / "elsewhere";
    const std::function<void()> no_wait = [] { FAIL() << "nobody else writes"; };
};

TEST_F(LateArrays, AreListedAndCannotBeRead) {
    const auto dataset = open();
    EXPECT_EQ(dataset->info().late.inputs, std::vector<std::string>{"/data/box.vtu"});
    EXPECT_EQ(dataset->info().late.options.at("array"), (std::vector<std::string>{"p", "q"}));
    EXPECT_EQ(dataset->info().late.changed, 1234567890123456789);
    EXPECT_EQ(dataset->info().late.mesh, "a mesh");
    EXPECT_EQ(dataset->info().late.files, (std::vector<std::string>{"", "xxh3:1", "xxh3:2", ""}));
    ASSERT_EQ(dataset->steps().size(), 4U);
    EXPECT_TRUE(dataset->steps()[1].arrays.at("p").late);
    EXPECT_FALSE(dataset->steps()[3].arrays.at("p").late);
    EXPECT_EQ(dataset->late_chunks(2), (std::map<std::string, std::uint64_t>{{"cell:q", 2}, {"p", 2}}));
    EXPECT_THROW((void)dataset->values("p", 1), Error);
    EXPECT_THAT(dataset->values("p", 3), ElementsAreArray(test::values_of(27, 3)));
    EXPECT_NO_THROW(dataset->verify());
}

TEST_F(LateArrays, AreReadLikeOthersOnceTheyAreWritten) {
    const auto before = open();
    (void)before->steps()[2];
    {
        LateWriter writer(open(), {}, no_wait);
        EXPECT_TRUE(writer.lacks(2));
        fill(writer, 2);
        EXPECT_FALSE(writer.lacks(2));
    }
    const auto now = before->refreshed();
    ASSERT_NE(now, nullptr);
    EXPECT_EQ(now->refreshed(), nullptr);
    for (const auto& dataset : {now, open()}) {
        EXPECT_THAT(dataset->values("p", 2), ElementsAreArray(test::values_of(27, 2)));
        EXPECT_FALSE(dataset->steps()[2].arrays.at("p").late);
        EXPECT_TRUE(dataset->steps()[1].arrays.at("p").late);
        const ArrayStep& cells = dataset->steps()[2].arrays.at("cell:q");
        EXPECT_TRUE(cells.has_checksum);
        ASSERT_EQ(cells.extremes.size(), 1U);
        EXPECT_NE(cells.extremes[0].highest.place, Vec3d{});
        EXPECT_TRUE(dataset->block_ranges({"p", std::nullopt, false}, 2));
        EXPECT_TRUE(dataset->histogram({"p", std::nullopt, false}, 2));
        EXPECT_NO_THROW(dataset->verify());
    }
}

TEST_F(LateArrays, HaveTheBytesOfAWholeImport) {
    {
        LateWriter writer(open(), {}, no_wait);
        for (const std::size_t step : {1U, 2U}) fill(writer, step);
    }
    const fs::path whole = scratch / "whole.ciel";
    {
        Writer writer(whole, {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(test::box(2, 2, 2), test::identity(27), test::identity(8), {});
        for (const std::size_t step : {0U, 1U, 2U, 3U}) add(writer, step);
        writer.finish();
    }
    const auto late = open(), expected = Dataset::open(whole);
    for (const std::size_t step : {1U, 2U})
        for (const char* array : {"p", "cell:q"}) {
            const ArrayStep &a = late->steps()[step].arrays.at(array), &b = expected->steps()[step].arrays.at(array);
            EXPECT_EQ(a.range, b.range);
            EXPECT_EQ(a.invalid, b.invalid);
            ASSERT_EQ(a.extremes.size(), b.extremes.size());
            for (std::size_t i = 0; i < a.extremes.size(); ++i)
                EXPECT_EQ(a.extremes[i].lowest.place, b.extremes[i].lowest.place);
            EXPECT_THAT(late->values(array, step), ElementsAreArray(expected->values(array, step)));
        }
}

TEST_F(LateArrays, AreAbsentIfTheSourceDoesNotHaveThem) {
    LateWriter writer(open(), {}, no_wait);
    const auto points = test::values_of(27, 1);
    writer.put(1, {p, points});
    writer.end_step(1);
    const auto dataset = open();
    EXPECT_FALSE(dataset->steps()[1].arrays.contains("cell:q"));
    EXPECT_TRUE(dataset->values("cell:q", 1).empty());
    EXPECT_THAT(dataset->values("p", 1), ElementsAreArray(points));
}

TEST_F(LateArrays, OfADatasetThatCannotBeWrittenToAreElsewhere) {
    const auto marker = test::read_file(directory / "steps.json");
    {
        LateWriter writer(open(elsewhere), elsewhere, no_wait, LateWriter::Where::elsewhere);
        fill(writer, 1);
    }
    EXPECT_FALSE(fs::exists(directory / "late"));
    EXPECT_EQ(test::read_file(directory / "steps.json"), marker);
    const auto dataset = open(elsewhere);
    EXPECT_THAT(dataset->values("p", 1), ElementsAreArray(test::values_of(27, 1)));
    EXPECT_TRUE(dataset->block_ranges({"p", std::nullopt, false}, 1));
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_TRUE(open()->steps()[1].arrays.at("p").late) << "without the folder";
}

TEST_F(LateArrays, OfADatasetThatWasReplacedOrRemovedAreForgotten) {
    const auto write = [&](const fs::path& dataset) {
        LateWriter writer(Dataset::open(dataset, LackingRanges::computed, std::nullopt, elsewhere), elsewhere, no_wait,
                          LateWriter::Where::elsewhere);
        fill(writer, 1);
        return writer.directory();
    };
    const fs::path away = scratch / "disk/away.ciel", gone = scratch / "gone.ciel";
    fs::create_directories(away.parent_path());
    fs::copy(directory, away, fs::copy_options::recursive);
    fs::copy(directory, gone, fs::copy_options::recursive);
    const fs::path kept = write(directory);
    const auto are_there = [&] {
        remove_forgotten_late_files(elsewhere);
        return fs::exists(kept / "late");
    };
    EXPECT_TRUE(are_there());
    test::overwrite_file(directory / ".zattrs", "{");
    EXPECT_TRUE(are_there()) << "a damaged dataset may be mended";
    fs::remove_all(directory);
    test::write_box(directory, test::box(2, 2, 2)); // has another id
    EXPECT_FALSE(are_there());
    EXPECT_EQ(write(away), kept) << "the copies have one id";
    fs::remove_all(away.parent_path());
    EXPECT_TRUE(are_there()) << "its disk may come back";
    EXPECT_EQ(write(gone), kept);
    fs::remove_all(gone);
    EXPECT_FALSE(are_there());
}

TEST_F(LateArrays, AreStillLateAfterAKillBetweenTheirFiles) {
    {
        LateWriter writer(open(), {}, no_wait);
        fill(writer, 1);
    }
    fs::remove(directory / "meshes/0/arrays/p/1.0"); // the chunk is written last
    EXPECT_TRUE(open()->steps()[1].arrays.at("p").late);
    LateWriter again(open(), {}, no_wait);
    EXPECT_TRUE(again.lacks(1, "p"));
    EXPECT_FALSE(again.lacks(1, "cell:q"));
    fill(again, 1);
    EXPECT_THAT(open()->values("p", 1), ElementsAreArray(test::values_of(27, 1)));
}

TEST_F(LateArrays, AreWrittenByOneProcessAtATime) {
    std::atomic<int> waits{0};
    std::jthread second;
    {
        const LateWriter first(open(), {}, no_wait);
        second = std::jthread([&] { LateWriter(open(), {}, [&] { ++waits; }); });
        while (waits == 0) std::this_thread::yield();
    }
    second.join();
    EXPECT_GT(waits, 0);
    const LateWriter holder(open(), {}, no_wait);
    EXPECT_THROW(LateWriter(open(), {}, [] { throw Error("given up"); }), Error);
}

TEST_F(LateArrays, OfAWrongSizeAreRefused) {
    LateWriter writer(open(), {}, no_wait);
    const std::vector<float> few(3, 1);
    EXPECT_THROW(writer.put(1, {p, few}), Error);
    EXPECT_TRUE(writer.lacks(1, "p"));
}

TEST_F(LateArrays, WithDamagedFactsAreLateAgain) {
    {
        LateWriter writer(open(), {}, no_wait);
        fill(writer, 1);
    }
    for (const char* text : {"", "{", "[]", R"({"chunk": 7})", R"({"chunk": 1, "checksum": "?"})"}) {
        test::overwrite_file(directory / "meshes/0/arrays/p/late/1", text);
        EXPECT_TRUE(open()->steps()[1].arrays.at("p").late) << text;
    }
    LateWriter writer(open(), {}, no_wait);
    fill(writer, 1);
    EXPECT_THAT(open()->values("p", 1), ElementsAreArray(test::values_of(27, 1)));
}

TEST_F(LateArrays, AreAskedForWhenTheyAreShown) {
    std::vector<std::size_t> asked;
    LoadedDataset loaded(open(), 1 << 20, [&](const Dataset&, std::size_t step) {
        asked.push_back(step);
        return LateAnswer{"is being read", false};
    });
    try {
        (void)loaded.scalar("p", 2);
        FAIL() << "it was never written";
    } catch (const NotYetRead& error) {
        EXPECT_THAT(error.what(), HasSubstr("'p' at time 2 is being read"));
        EXPECT_FALSE(error.has_failed);
    }
    EXPECT_EQ(asked, std::vector<std::size_t>{2});
    (void)loaded.scalar("p", 3);
    {
        LateWriter writer(open(), {}, no_wait);
        fill(writer, 2);
    }
    EXPECT_TRUE(loaded.refresh());
    EXPECT_THAT(loaded.scalar_values("p", 2), ElementsAreArray(test::values_of(27, 2)));
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(LateArrays, MayBeInTheTableOfSteps) {
    const fs::path many = scratch / "many.ciel";
    Writer writer(many, {"box.vtu", "m", 27, 54, 8, {}});
    writer.add_mesh(test::box(2, 2, 2), test::identity(27), test::identity(8), {});
    add(writer, 0);
    for (int step = 1; step < 100; ++step) writer.add_late_step(step, 0, 0, std::vector<ArrayInfo>{p, q});
    add(writer, 100);
    writer.finish();
    LateWriter late(Dataset::open(many), {}, no_wait);
    fill(late, 57);
    const auto dataset = Dataset::open(many);
    EXPECT_THAT(dataset->values("p", 57), ElementsAreArray(test::values_of(27, 57)));
    EXPECT_TRUE(dataset->steps()[58].arrays.at("p").late);
}

} // namespace
} // namespace server::store
