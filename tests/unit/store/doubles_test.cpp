// Arrays of doubles: what is read equals what was written, to the last bit, in values, ranges, scalars and fields.
#include "store/append.hpp"
#include "store/loaded.hpp"
#include "store/no_value.hpp"
#include "support/store_box/box.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

// Values that differ from each other only as doubles.
std::vector<double> close_values(std::size_t count) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = 101325 + 0.01 * std::sin(static_cast<double>(i));
    return values;
}

// A dataset of 2 x 2 x 2 cells at the time 0.
class DoublesTest : public testing::Test {
protected:
    void write(const std::vector<ArrayValues>& arrays) const {
        Writer writer(directory, {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(test::box(2, 2, 2), test::identity(27), test::identity(8), {});
        writer.add_step(0, 0, 0, arrays);
        writer.finish();
    }
    [[nodiscard]] std::shared_ptr<Dataset> open() const { return Dataset::open(directory); }

    test::Folder scratch;
    std::filesystem::path directory = scratch / "box.ciel";
    std::vector<double> p = close_values(27), u = close_values(81), cells = close_values(8);
    std::vector<float> floats = test::values_of(27, 0);
};

TEST_F(DoublesTest, AreReadAsTheyWereWritten) {
    cells[3] = no_value;
    cells[4] = std::nan("");
    write({{{"p", Association::point, 1, "", ""}, p},
           {{"U", Association::point, 3, "", ""}, u},
           {{"cell:p", Association::cell, 1, "", ""}, cells},
           {{"f", Association::point, 1, "", ""}, floats}});
    const auto dataset = open();
    EXPECT_NO_THROW(dataset->verify());
    for (const char* name : {"p", "U", "cell:p"}) EXPECT_TRUE(dataset->find(name)->doubles) << name;
    EXPECT_FALSE(dataset->find("f")->doubles);
    EXPECT_THAT(dataset->values("p", 0), ElementsAreArray(p));
    EXPECT_THAT(dataset->values("U", 0), ElementsAreArray(u));
    EXPECT_THAT(test::read_file(directory / "meshes/0/arrays/p/.zarray"), testing::HasSubstr("\"<f8\""));
    const Values of_cells = dataset->values("cell:p", 0);
    EXPECT_TRUE(is_no_value(of_cells[3]));
    EXPECT_TRUE(went_wrong(of_cells[4]));
    const ArrayStep& found = dataset->steps()[0].arrays.at("cell:p");
    EXPECT_EQ(found.missing, 1U);
    EXPECT_EQ(found.invalid, 1U);
}

TEST_F(DoublesTest, RangesScalarsAndFieldsHaveThemToTheBit) {
    write({{{"p", Association::point, 1, "", ""}, p}, {{"U", Association::point, 3, "", ""}, u}});
    const auto dataset = open();
    const auto [low, high] = std::ranges::minmax(p);
    EXPECT_THAT(dataset->steps()[0].arrays.at("p").range, ElementsAre(low, high));
    const auto ranges = dataset->block_ranges({"p", std::nullopt, false}, 0);
    ASSERT_TRUE(ranges);
    EXPECT_THAT(ranges->low, ElementsAre(low));
    EXPECT_THAT(ranges->high, ElementsAre(high));
    LoadedDataset loaded(dataset, 1 << 20);
    EXPECT_THAT(loaded.scalar_values("p", 0), ElementsAreArray(p));
    EXPECT_THAT(loaded.scalar("p", 0).field->range(), ElementsAre(low, high));
    const Values y = loaded.scalar_values("U:y", 0), magnitude = loaded.scalar_values("U:magnitude", 0);
    ASSERT_TRUE(y.has_doubles() && magnitude.has_doubles());
    for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_EQ(y[i], u[3 * i + 1]);
        EXPECT_DOUBLE_EQ(magnitude[i], std::hypot(u[3 * i], u[3 * i + 1], u[3 * i + 2]));
    }
}

TEST_F(DoublesTest, LaterStepsHaveTheTypeOfTheFirst) {
    write({{{"p", Association::point, 1, "", ""}, p}, {{"f", Association::point, 1, "", ""}, floats}});
    Writer writer = Writer::append(directory);
    writer.add_step(1, 0, 0,
                    std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, floats},
                                             {{"f", Association::point, 1, "", ""}, p}});
    writer.finish();
    const auto dataset = open();
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_TRUE(dataset->values("p", 1).has_doubles());
    EXPECT_THAT(dataset->values("p", 1), ElementsAreArray(floats));
    EXPECT_THAT(dataset->values("f", 1), ElementsAreArray(std::vector<float>(p.begin(), p.end())));
}

TEST_F(DoublesTest, AreAppendedAndSaidToBeRounded) {
    write({{{"p", Association::point, 1, "", ""}, p},
           {{"f", Association::point, 1, "", ""}, floats},
           {{"cell:f", Association::cell, 1, "", ""}, std::vector<float>(8)}});
    const std::vector<WantedArray> wanted{
        {"p", {}, true}, {"f", {}, true}, {"q", {}, true}, {"cell:w", {}, true}, {"g", {}, false}};
    const std::vector<ValuesView> values{p, p, p, cells, floats};
    const auto done = append_step(open(), 1, wanted, [&](std::size_t i) { return values[i]; });
    EXPECT_THAT(done.plan.rounded, ElementsAre("f"));
    EXPECT_EQ(done.plan.stored_bytes, 27 * (8 + 4 + 8 + 8 + 4) + 8 * 8U) << "w is also made on the points";
    const auto dataset = open();
    for (const char* name : {"p", "q"}) EXPECT_THAT(dataset->values(name, 1), ElementsAreArray(p)) << name;
    EXPECT_THAT(dataset->values("cell:w", 1), ElementsAreArray(cells));
    EXPECT_THAT(dataset->values("f", 1), ElementsAreArray(std::vector<float>(p.begin(), p.end())));
    EXPECT_TRUE(dataset->find("w")->doubles) << "made from cell:w";
    EXPECT_EQ(dataset->values("w", 1)[0], cells[0]) << "a corner of the box has one cell";
    EXPECT_FALSE(dataset->find("g")->doubles);
}

TEST_F(DoublesTest, OtherTypesAreRefused) {
    write({{{"p", Association::point, 1, "", ""}, p}});
    const auto document = directory / "meshes/0/arrays/p/.zarray";
    std::string text = test::read_file(document);
    text.replace(text.find("<f8"), 3, "<i8");
    test::overwrite_file(document, text);
    try {
        (void)open();
        ADD_FAILURE() << "integers were read as doubles";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("float32 or float64"));
    }
}

} // namespace
} // namespace server::store
