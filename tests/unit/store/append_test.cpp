// Rules of appending: names, sizes and times, order of the imported file, point values, coordinates.
#include "store/append.hpp"
#include "store/mesh_arrays.hpp"
#include "support/store_box/box.hpp"
#include "support/store_box/format_1.hpp"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <sys/wait.h>
#include <unistd.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::IsEmpty;

// Dataset of 2 x 2 x 2 cells. Its vertices and cells are stored in the reverse order of the imported "file".
class AppendTest : public testing::Test {
protected:
    AppendTest() {
        const FaceMesh mesh = test::box(2, 2, 2);
        std::vector<Index> vertices = test::identity(27), cells = test::identity(8);
        std::ranges::reverse(vertices);
        std::ranges::reverse(cells);
        Writer writer(directory, {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(mesh, vertices, cells, {});
        const auto p = test::values_of(27, 0), u = test::values_of(81, 0), c = test::values_of(8, 0);
        const std::vector<ArrayValues> arrays{{{"p", Association::point, 1, "Pa", "pressure"}, p},
                                              {{"U", Association::point, 3, "m/s", ""}, u},
                                              {{"cell:p", Association::cell, 1, "Pa", ""}, c},
                                              {{"cell:id", Association::cell, 1, "", ""}, c}};
        writer.add_step(0, 0, 0, arrays);
        writer.finish();
    }

    [[nodiscard]] std::shared_ptr<Dataset> open() const { return Dataset::open(directory, LackingRanges::left_out); }
    AppendedStep append(double time, const std::vector<WantedArray>& wanted,
                        const std::vector<std::vector<float>>& values) const {
        return append_step(open(), time, wanted, [&](std::size_t i) { return std::span<const float>(values[i]); });
    }

    test::Folder scratch;
    fs::path directory = scratch / "box.ciel";
};

struct Refused {
    const char* name;
    double time;
    std::vector<WantedArray> wanted;
    const char* sentence;
};

const double nan = std::numeric_limits<double>::quiet_NaN();
const std::string long_name(201, 'x');
const std::vector<Refused> refused{
    {"the same time", 0, {{"p", {}}}, "time 0 is not later than the last step of box, which is at time 0"},
    {"an earlier time", -1, {{"p", {}}}, "not later"},
    {"no time", nan, {{"p", {}}}, "must be a finite number"},
    {"twice", 1, {{"p", {}}, {"p", {}}}, "'p' is given twice"},
    {"other components", 1, {{"U", 2}}, "'U' has 3 components in the dataset, but the values have 2"},
    {"no components", 1, {{"new", 0}}, "1 to 64"},
    {"too many components", 1, {{"new", 65}}, "1 to 64"},
    {"an empty name", 1, {{"", {}}}, "is empty"},
    {"an empty cell name", 1, {{"cell:", {}}}, "is empty"},
    {"a path", 1, {{"../x", {}}}, "holds a '/'"},
    {"a drive", 1, {{"a:b", {}}}, "':'"},
    {"a folder", 1, {{"..", {}}}, "is . or .."},
    {"a space", 1, {{"p ", {}}}, "begins or ends with a space"},
    {"a line feed", 1, {{"a\nb", {}}}, "control character"},
    {"a long name", 1, {{long_name, {}}}, "longer than 200 bytes"},
};

TEST_F(AppendTest, WhatIsRefusedIsRefusedBeforeAnyValue) {
    const auto dataset = open();
    for (const Refused& row : refused) {
        try {
            (void)plan_step(*dataset, row.time, row.wanted);
            ADD_FAILURE() << row.name;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(row.sentence)) << row.name;
        }
    }
}

TEST_F(AppendTest, AWrongNumberOfValuesLeavesNoChunk) {
    EXPECT_THROW((void)append(1, {{"p", {}}, {"U", {}}}, {std::vector<float>(27), std::vector<float>(80)}), Error);
    EXPECT_FALSE(fs::exists(directory / "meshes/0/arrays/p/1.0"));
    EXPECT_EQ(open()->steps().size(), 1U);
}

TEST_F(AppendTest, ValuesComeInTheOrderOfTheImportedFile) {
    auto p = test::values_of(27, 1);
    const auto done = append(1, {{"p", {}}}, {p});
    std::ranges::reverse(p);
    EXPECT_EQ(done.step, 1U);
    EXPECT_THAT(Dataset::open(directory)->values("p", 1), ElementsAreArray(p));
    EXPECT_THAT(done.plan.added, IsEmpty());
    EXPECT_THAT(done.plan.lacking, testing::UnorderedElementsAre("U", "cell:p", "cell:id"));
}

// The middle vertex touches all eight cells; a corner vertex of the box touches one.
TEST_F(AppendTest, CellArraysGetTheirPointValues) {
    const std::vector<float> in_file{8, 7, 6, 5, 4, 3, 2, 1}; // stored as 1 to 8
    const auto done = append(1, {{"cell:p", {}}}, {in_file});
    const auto dataset = Dataset::open(directory);
    const auto p = dataset->values("p", 1);
    ASSERT_EQ(p.size(), 27U);
    EXPECT_FLOAT_EQ(p[0], 1);
    EXPECT_FLOAT_EQ(p[13], 4.5);
    EXPECT_FLOAT_EQ(p[26], 8);
    EXPECT_THAT(dataset->values("cell:p", 1), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_EQ(done.plan.arrays[0].made->name, "p");
    EXPECT_THAT(done.plan.lacking, testing::UnorderedElementsAre("U", "cell:id"));
}

TEST_F(AppendTest, AsAnImportDoesNotMakePointValuesThatAreThereOrThatNobodyWanted) {
    const std::vector<float> cells(8, 5), points(27, 7), vectors(24, 1);
    (void)append(1, {{"cell:p", {}}, {"p", {}}}, {cells, points});
    EXPECT_THAT(open()->values("p", 1), ElementsAreArray(points));
    (void)append(2, {{"cell:id", {}}}, {cells});
    EXPECT_EQ(open()->find("id"), nullptr) << "the import kept the cell values alone";
    const auto fresh = append(3, {{"cell:w", 3}}, {vectors});
    EXPECT_THAT(fresh.plan.added, ElementsAre("cell:w", "w"));
    EXPECT_EQ(open()->find("w")->components, 3);
    EXPECT_THAT(open()->values("w", 3), ElementsAreArray(std::vector<float>(81, 1)));
}

TEST_F(AppendTest, AKillInTheMiddleOfTheCommitLeavesTheDatasetAsItWas) {
    const std::vector<float> p(27, 1), u(81, 2);
    const pid_t child = ::fork();
    if (child == 0) {
        (void)append_step(open(), 1, std::vector<WantedArray>{{"p", {}}, {"U", {}}}, [&](std::size_t i) {
            if (i == 1) ::kill(::getpid(), SIGKILL); // p is written and the lock is held
            return std::span<const float>(p);
        });
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_TRUE(fs::exists(directory / "meshes/0/arrays/p/1.0")) << "too early to prove anything";
    const auto dataset = Dataset::open(directory);
    EXPECT_EQ(dataset->steps().size(), 1U);
    EXPECT_EQ(append(1, {{"p", {}}, {"U", {}}}, {p, u}).step, 1U);
    EXPECT_THAT(dataset->refreshed()->values("U", 1), testing::Each(2.0F));
}

// Changes bytes in place, as a disk error or another program would.
void overwrite_index(const fs::path& file, std::size_t at, Index value) {
    std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(static_cast<std::streamoff>(at * sizeof value));
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

TEST_F(AppendTest, AnIndexThatChangedAfterItWasVerifiedIsASentence) {
    const std::vector<float> cells(8, 1);
    test::make_format_1(directory, test::box(2, 2, 2));
    for (const char* array : {"face_vertex/0", "owner/0", "neighbour/0"}) {
        const auto dataset = open();
        const fs::path file = directory / "meshes/0" / array;
        const std::string good = test::read_file(file);
        overwrite_index(file, 1, 4'000'000'000U);
        try {
            (void)append_step(dataset, 1, std::vector<WantedArray>{{"cell:p", {}}},
                              [&](std::size_t) { return std::span<const float>(cells); });
            ADD_FAILURE() << array;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(array), HasSubstr("changed while it was open")));
        }
        test::overwrite_file(file, good);
        EXPECT_EQ(open()->steps().size(), 1U);
    }
}

// Writes the box at the times 1, 2, 3, ..., with positions offset by `moved[i]`.
void write_moving(const fs::path& directory, const std::vector<float>& moved, Vec3d origin = {}) {
    FaceMesh mesh = test::box(2, 2, 2);
    mesh.origin = origin;
    Writer writer(directory, {});
    writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
    std::size_t set = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        std::vector<float> positions = mesh.positions;
        for (float& x : positions) x += moved[i];
        if (i > 0) set = moved[i] == moved[i - 1] ? set : writer.add_coordinates(0, positions);
        const auto p = test::values_of(27, i);
        writer.add_step(static_cast<double>(i + 1), 0, set,
                        std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, p}});
    }
    writer.finish();
}

std::size_t position_sets(const fs::path& dataset) {
    std::size_t sets = 0;
    for (const auto& entry : fs::directory_iterator(dataset / "meshes/0/positions"))
        if (entry.path().filename().string().ends_with(".0.0")) ++sets;
    return sets;
}

TEST_F(AppendTest, AMeshThatMovesOnceHasItsPositionsOnce) {
    write_moving(scratch / "moving.ciel", {0, 1, 1, 1, 2, 1, 0});
    EXPECT_EQ(append_dataset(open(), *Dataset::open(scratch / "moving.ciel")), 7U);
    const auto dataset = Dataset::open(directory);
    std::vector<std::size_t> coordinates;
    for (const Step& step : dataset->steps()) coordinates.push_back(step.coordinates);
    EXPECT_THAT(coordinates, ElementsAre(0, 0, 1, 1, 1, 2, 1, 0));
    EXPECT_EQ(position_sets(directory), 3U);
    EXPECT_EQ(dataset->mesh_arrays().points(0, 2).positions[0], 2);
}

TEST_F(AppendTest, AMovingMeshOfAnotherOriginIsOffset) {
    write_moving(scratch / "far.ciel", {0, 1, 1}, {100, 0, 0});
    EXPECT_EQ(append_dataset(open(), *Dataset::open(scratch / "far.ciel")), 3U);
    const auto dataset = Dataset::open(directory);
    EXPECT_EQ(position_sets(directory), 3U);
    EXPECT_EQ(dataset->mesh_arrays().points(0, dataset->steps()[1].coordinates).positions[0], 100);
    EXPECT_EQ(dataset->steps()[2].coordinates, dataset->steps()[3].coordinates);
}

} // namespace
} // namespace server::store
