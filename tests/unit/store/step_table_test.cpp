// The table of steps keeps every detail that the commit marker had, and ignores what was never committed.
#include "store/append.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/step_table.hpp"
#include "store/loaded.hpp"
#include "support/store_box/box.hpp"

#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const std::string id = "0123456789abcdef";

std::string text_of(const MarkedStep& step) { return to_text(Marker{3, {}, {step}}); }

std::vector<MarkedStep> steps_of_all_kinds() {
    ArrayStep vector;
    vector.range = {0.25, 1e300};
    vector.component_ranges = {{-1, 1}, {-0.0, 4e-324}, {2, 3}};
    vector.invalid = 7;
    ArrayStep cells;
    cells.range = {1, 2};
    cells.component_ranges = {{1, 2}};
    cells.missing = 3;
    cells.extremes = {{{4, {0.1, 0.2, 0.3}}, {5, {-1, 1e9, 0}}}};
    const MarkedArray plain{9, "", std::nullopt, false}, late{2, "", std::nullopt, true};
    const MarkedArray with_ranges{3, "xxh3:00ff00ff12345678", vector, false},
        with_extremes{4, "xxh3:fedcba9876543210", cells, false};
    return {{-1.5, 0, 0, {}},
            {0, 0, 1, {{"p", plain}, {"U", with_ranges}}},
            {0.5, 2, 0, {{"cell:p", with_extremes}, {"late one", late}, {"U", with_ranges}}},
            {1e99, 1, 4'000'000'000, {{"p", with_ranges}}}};
}

TEST(StepTable, SaysWhatTheMarkerSaid) {
    const test::Folder scratch;
    const std::vector<MarkedStep> steps = steps_of_all_kinds();
    TableFacts facts;
    for (std::size_t i = 0; i < steps.size(); i += 2)
        facts = append_to_table(scratch.path(), facts, id, std::span(steps).subspan(i, 2));
    EXPECT_EQ(facts.steps, steps.size());
    EXPECT_THAT(facts.chunks, testing::ElementsAre(10, 4, 5));
    const StepTable table(scratch.path(), facts, id);
    ASSERT_EQ(table.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(table.time(i), steps[i].time);
        EXPECT_EQ(text_of(table.step(i)), text_of(steps[i])) << i;
    }
}

TEST(StepTable, HasTheBytesThatTheReadmeShows) {
    const test::Folder scratch;
    ArrayStep p;
    p.range = {1, 2};
    p.component_ranges = {{1, 2}};
    p.extremes = {{{0, {0.5, 0, 0}}, {1, {1.5, 0, 0}}}};
    const std::vector<MarkedStep> steps{{0.5, 0, 0, {{"cell:p", {0, "xxh3:0123456789abcdef", p, false}}}}};
    (void)append_to_table(scratch.path(), {}, id, steps);
    std::string shown;
    for (const char* file : {"steps/rows", "steps/arrays"})
        shown += std::string(file) + '\n' + test::hex_dump(test::read_file(scratch / file));
    EXPECT_THAT(test::read_file(fs::path(CIEL_SOURCE_DIR) / "server/store/README.md"),
                HasSubstr("```\n" + shown + "```"))
        << "the README must show:\n"
        << shown;
}

// A dataset with more steps than the commit marker keeps, so that they are in the table.
class TabledSteps : public testing::Test {
protected:
    static constexpr std::size_t count = 150;

    TabledSteps() {
        Writer writer(directory, {});
        writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
        for (std::size_t step = 0; step < count; ++step) add(writer, step);
        writer.finish();
    }
    static void add(Writer& writer, std::size_t step) {
        const std::vector<float> p = test::values_of(27, step), of_cells = test::values_of(8, step);
        std::vector<ArrayValues> arrays{{{"p", Association::point, 1, "Pa", ""}, p}};
        if (step % 2 == 0) arrays.push_back({{"cell:q", Association::cell, 1, "", ""}, of_cells});
        writer.add_step(0.5 * static_cast<double>(step), 0, 0, arrays);
    }
    static void expect_step(const Dataset& dataset, std::size_t step) {
        const Step& at = dataset.steps()[step];
        EXPECT_EQ(at.time, 0.5 * static_cast<double>(step));
        ASSERT_EQ(at.arrays.size(), 2 - step % 2);
        const std::vector<float> p = test::values_of(27, step);
        EXPECT_EQ(at.arrays.at("p").range[0], p.front());
        EXPECT_EQ(at.arrays.at("p").range[1], p.back());
        EXPECT_THAT(dataset.values("p", step), testing::ElementsAreArray(p));
        if (step % 2 == 0) {
            const auto& extremes = at.arrays.at("cell:q").extremes;
            ASSERT_EQ(extremes.size(), 1U);
            EXPECT_EQ(extremes[0].highest.cell, 7U);
        }
    }
    [[nodiscard]] json marker() const { return json::parse(test::read_file(directory / "steps.json")); }
    [[nodiscard]] std::shared_ptr<Dataset> open() const { return Dataset::open(directory); }

    test::Folder scratch;
    FaceMesh mesh = test::box(2, 2, 2);
    fs::path directory = scratch / "m.ciel";
};

TEST_F(TabledSteps, AreInATable) {
    EXPECT_EQ(marker()["ciel_steps"], 2);
    EXPECT_EQ(marker()["table"]["steps"], count);
    EXPECT_TRUE(marker()["steps"].empty());
    const auto dataset = open();
    ASSERT_EQ(dataset->steps().size(), count);
    EXPECT_EQ(dataset->info().arrays.size(), 2U);
    for (std::size_t step = 0; step < count; ++step) expect_step(*dataset, step);
    dataset->verify();
    EXPECT_EQ(dataset->step_at(30.2), 60U);
    EXPECT_EQ(dataset->step_at(30.25), 60U);
    EXPECT_EQ(dataset->step_at(30.3), 61U);
    EXPECT_EQ(dataset->step_at(-9), 0U);
    EXPECT_EQ(dataset->step_at(1e9), count - 1);
}

TEST_F(TabledSteps, AreReadWhenTheyAreAskedForOnly) {
    std::string bytes = test::read_file(directory / "steps/arrays");
    bytes.back() ^= 1;
    test::overwrite_file(directory / "steps/arrays", bytes);
    const auto dataset = open();
    EXPECT_EQ(dataset->steps().times().back(), 0.5 * (count - 1));
    expect_step(*dataset, count - 2);
    EXPECT_THROW((void)dataset->steps()[count - 1], Error);
    EXPECT_THROW(dataset->verify(), Error);
}

TEST_F(TabledSteps, AreAppendedOneByOne) {
    constexpr std::size_t more = 140;
    auto open_before = open();
    const Step& first = open_before->steps().front();
    for (std::size_t step = count; step < count + more; ++step) {
        Writer writer = Writer::append(directory);
        add(writer, step);
        EXPECT_LE(marker()["steps"].size(), 64U);
    }
    EXPECT_EQ(marker()["table"]["steps"], count + 130);
    EXPECT_EQ(marker()["steps"].size(), 10U);
    const auto refreshed = open_before->refreshed(), dataset = open();
    ASSERT_EQ(refreshed->steps().size(), count + more);
    ASSERT_EQ(dataset->steps().size(), count + more);
    EXPECT_EQ(&refreshed->steps().front(), &first) << "what was read stays";
    for (std::size_t step = 0; step < count + more; step += 7) {
        expect_step(*refreshed, step);
        expect_step(*dataset, step);
    }
    EXPECT_EQ(open_before->steps().size(), count);
    EXPECT_THROW(add(*std::make_unique<Writer>(Writer::append(directory)), count + more - 1), Error);
}

TEST_F(TabledSteps, MayBeFollowedByThoseOfPlainZarr) {
    const fs::path p = directory / "meshes/0/arrays/p";
    const std::vector<float> values = test::values_of(27, 9);
    std::ofstream(p / (std::to_string(count) + ".0"), std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()), 27 * sizeof(float));
    json array = json::parse(test::read_file(p / ".zarray"));
    array["shape"][0] = count + 1;
    test::overwrite_file(p / ".zarray", array.dump());
    json edited = marker();
    edited["steps"].push_back({{"time", 1000}, {"arrays", {{"p", json::object()}}}});
    test::overwrite_file(directory / "steps.json", edited.dump());
    const auto dataset = open();
    ASSERT_EQ(dataset->steps().size(), count + 1);
    EXPECT_EQ(dataset->steps().back().arrays.at("p").range[1], values.back());
    EXPECT_THAT(dataset->values("p", count), testing::ElementsAreArray(values));
    EXPECT_THROW(add(*std::make_unique<Writer>(Writer::append(directory)), count), Error) << "is before 1000";
}

TEST_F(TabledSteps, OfAKilledWriterDoNotCount) {
    for (const char* file : {"steps/rows", "steps/arrays"})
        std::ofstream(directory / file, std::ios::app | std::ios::binary) << std::string(1000, 'x');
    expect_step(*open(), count - 1);
    for (std::size_t step = count; step < count + 65; ++step) {
        Writer writer = Writer::append(directory);
        add(writer, step);
    }
    EXPECT_EQ(marker()["table"]["steps"], count + 65);
    EXPECT_EQ(fs::file_size(directory / "steps/rows"), 64 + 40 * (count + 65));
    const auto dataset = open();
    dataset->verify();
    for (std::size_t step = count - 3; step < count + 65; ++step) expect_step(*dataset, step);
}

TEST_F(TabledSteps, AreCountedByTheWriterThatAppendsADataset) {
    const fs::path few = scratch / "few.ciel";
    {
        Writer writer(few, {});
        writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
        add(writer, 0);
        writer.finish();
    }
    EXPECT_EQ(append_dataset(Dataset::open(few), *open()), count - 1);
    const auto dataset = Dataset::open(few);
    ASSERT_EQ(dataset->steps().size(), count);
    for (std::size_t step = 0; step < count; ++step) expect_step(*dataset, step);
}

// A step is committed before it moves to the table. If the table cannot be written, appending still succeeds.
TEST_F(TabledSteps, StayInTheMarkerIfTheTableCannotBeWritten) {
    const fs::path few = scratch / "few.ciel";
    {
        Writer writer(few, {});
        writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
        writer.finish();
    }
    std::ofstream(few / "steps") << "no folder";
    for (std::size_t step = 0; step < 70; ++step) {
        Writer writer = Writer::append(few);
        add(writer, step);
    }
    EXPECT_EQ(Dataset::open(few)->steps().size(), 70U);
    EXPECT_EQ(json::parse(test::read_file(few / "steps.json"))["steps"].size(), 70U);
    fs::remove(few / "steps");
    {
        Writer writer = Writer::append(few);
        add(writer, 70);
    }
    EXPECT_EQ(json::parse(test::read_file(few / "steps.json"))["table"]["steps"], 71);
    expect_step(*Dataset::open(few), 70);
}

TEST_F(TabledSteps, OfABackupWithHardLinksStayAsTheyAre) {
    const fs::path backup = scratch / "backup.ciel";
    fs::copy(directory, backup, fs::copy_options::recursive | fs::copy_options::create_hard_links);
    for (std::size_t step = count; step < count + 65; ++step) {
        Writer writer = Writer::append(directory);
        add(writer, step);
    }
    for (std::size_t step = count; step < count + 65; ++step) {
        Writer writer = Writer::append(backup);
        writer.add_step(1000.0 + static_cast<double>(step), 0, 0, {});
    }
    open()->verify();
    expect_step(*open(), count + 64);
    Dataset::open(backup)->verify();
    EXPECT_EQ(Dataset::open(backup)->steps().back().arrays.size(), 0U);
}

// The table tells which arrays each mesh has. Directories of arrays that no step names are not read.
TEST_F(TabledSteps, NameTheMeshesOfTheirArrays) {
    const fs::path two = scratch / "two.ciel";
    const std::vector<float> p = test::values_of(27, 1), q = test::values_of(8, 1);
    {
        Writer writer(two, {});
        writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
        writer.add_mesh(test::box(1, 1, 1), test::identity(8), test::identity(1), {});
        const ArrayInfo p_info{"p", Association::point, 1, "", ""}, q_info{"q", Association::point, 1, "", ""};
        for (std::size_t step = 0; step < 80; ++step)
            writer.add_step(static_cast<double>(step), step / 40, 0,
                            std::vector<ArrayValues>{step < 40 ? ArrayValues{p_info, p} : ArrayValues{q_info, q}});
        writer.finish();
    }
    fs::create_directories(two / "meshes/1/arrays/p");
    std::ofstream(two / "meshes/1/arrays/p/.zarray") << "half a docu";
    const auto dataset = Dataset::open(two);
    dataset->verify();
    EXPECT_EQ(dataset->info().arrays.size(), 2U);
    EXPECT_THAT(dataset->values("q", 79), testing::ElementsAreArray(q));
    EXPECT_TRUE(dataset->values("p", 79).empty());
}

struct Damage {
    const char* name;
    const char* file;
    void (*change)(std::string& bytes);
    const char* sentence;
};

void write_at(std::string& bytes, std::size_t at, std::uint32_t value) {
    std::memcpy(&bytes[at], &value, sizeof value);
}

const std::vector<Damage> damages{
    {"rows cut off", "steps/rows", [](std::string& b) { b.resize(1000); }, "the commit marker needs 6064"},
    {"no rows", "steps/rows", [](std::string& b) { b.clear(); }, "has 0 bytes"},
    {"rows changed", "steps/rows", [](std::string& b) { b[500] ^= 1; }, "does not match the checksum in the commit"},
    {"another kind", "steps/rows", [](std::string& b) { b[8] = 'i'; }, "does not begin with the bytes"},
    {"another dataset", "steps/rows", [](std::string& b) { b[16] ^= 1; }, "belongs to another dataset"},
    {"arrays of another dataset", "steps/arrays", [](std::string& b) { b[16] ^= 1; }, "belongs to another dataset"},
    {"arrays cut off", "steps/arrays", [](std::string& b) { b.resize(70); }, "steps/arrays"},
    {"no arrays", "steps/arrays", [](std::string& b) { b.resize(10); }, "has 10 bytes"},
    {"arrays changed", "steps/arrays", [](std::string& b) { b[100] ^= 1; }, "does not match the checksum of step 0"},
};

TEST_F(TabledSteps, ThatAreDamagedAreRefused) {
    for (const Damage& damage : damages) {
        const std::string before = test::read_file(directory / damage.file);
        std::string bytes = before;
        damage.change(bytes);
        test::overwrite_file(directory / damage.file, bytes);
        try {
            (void)open()->steps()[0];
            ADD_FAILURE() << damage.name;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(damage.sentence)) << damage.name;
        }
        test::overwrite_file(directory / damage.file, before);
    }
    expect_step(*open(), 0);
}

// Changes the entry of a step and corrects the checksums. Arrays and chunks that do not exist, and wrong counts, must
// be refused.
TEST_F(TabledSteps, ThatNameWhatDoesNotExistAreRefused) {
    const std::string arrays = test::read_file(directory / "steps/arrays");
    const auto refusal = [&](std::size_t at, std::uint32_t value) -> std::string {
        std::string changed = arrays, rows = test::read_file(directory / "steps/rows");
        write_at(changed, at, value);
        std::uint64_t begin = 0;
        std::uint32_t bytes = 0;
        std::memcpy(&begin, &rows[64 + 16], sizeof begin);
        std::memcpy(&bytes, &rows[64 + 24], sizeof bytes);
        const std::uint64_t sum = checksum_number(bytes_of(std::string_view(changed).substr(begin, bytes)));
        const std::string rows_before = rows, marker_before = test::read_file(directory / "steps.json");
        std::memcpy(&rows[64 + 32], &sum, sizeof sum);
        json edited = marker();
        edited["table"]["checksum"] = checksum(bytes_of(std::string_view(rows).substr(64, 40 * count)));
        test::overwrite_file(directory / "steps/arrays", changed);
        test::overwrite_file(directory / "steps/rows", rows);
        test::overwrite_file(directory / "steps.json", edited.dump());
        std::string sentence;
        try {
            (void)open()->steps()[0];
        } catch (const Error& error) {
            sentence = error.what();
        }
        test::overwrite_file(directory / "steps/rows", rows_before);
        test::overwrite_file(directory / "steps.json", marker_before);
        return sentence;
    };
    EXPECT_EQ(refusal(64, 0), "");
    EXPECT_THAT(refusal(64, 77), HasSubstr("has an array that the commit marker does not list for the step's mesh"));
    EXPECT_THAT(refusal(64 + 8, 100'000), HasSubstr("the commit marker lists step 100000"));
    EXPECT_THAT(refusal(64 + 56, 2), HasSubstr("is damaged"));
    EXPECT_THAT(refusal(64 + 56, 1'000'000), HasSubstr("lacks the last bytes of a step"));
    EXPECT_THAT(refusal(64 + 4, 0), HasSubstr("is damaged"));
    EXPECT_THAT(refusal(64 + 60, 0), HasSubstr("is damaged"));
}

} // namespace
} // namespace server::store
