#include "ciel/types.hpp"
#include "import/parsers/index_entry.hpp"

#include <algorithm>
#include <gmock/gmock.h>

namespace server::importer {
using namespace ciel;
namespace {

using ::testing::HasSubstr;
using Parse = std::vector<IndexEntry> (*)(std::string_view, const std::string&);

TEST(Pvd, entries_come_sorted_by_time_and_keep_their_order_within_one) {
    const auto entries = parse_pvd(R"(<?xml version="1.0"?><VTKFile type="Collection"><Collection>
        <DataSet timestep="2" part="0" file="c.vtu"/>
        <DataSet timestep="-1e-1" group="" part="0" file="a.vtu"/>
        <DataSet timestep="2" part="1" name="tail" file="d&amp;e.vtu"/>
        <DataSet file="b.vtu"/></Collection></VTKFile>)",
                                   "x.pvd");
    ASSERT_EQ(entries.size(), 4U);
    EXPECT_EQ(entries[0].file, "a.vtu");
    EXPECT_EQ(entries[0].time, -0.1);
    EXPECT_EQ(entries[1].file, "b.vtu");
    EXPECT_EQ(entries[1].time, 0);
    EXPECT_EQ(entries[2].piece, "0");
    EXPECT_EQ(entries[3].piece, "tail");
    EXPECT_EQ(entries[3].file, "d&e.vtu");
}

TEST(Series, entries_without_a_time_are_numbered) {
    const auto entries = parse_series(
        R"({"file-series-version":"1.0","files":[{"name":"a","time":3.5},{"name":"b"},{"name":"c","time":0}]})", "x");
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[0].file, "c");
    EXPECT_EQ(entries[1].file, "b");
    EXPECT_EQ(entries[1].time, 1);
    EXPECT_EQ(entries[2].time, 3.5);
}

struct Malformed {
    const char* name;
    Parse parse;
    std::string text;
    const char* error;
};

const Malformed malformed[] = {
    {"pvd empty", parse_pvd, "", "not well-formed XML"},
    {"pvd of another type", parse_pvd, R"(<VTKFile type="PolyData"/>)", "not a PVD file"},
    {"pvd without files", parse_pvd, R"(<VTKFile type="Collection"><Collection/></VTKFile>)", "names no files"},
    {"pvd entry without file", parse_pvd,
     R"(<VTKFile type="Collection"><Collection><DataSet timestep="1"/></Collection></VTKFile>)", "names no file"},
    {"pvd time in words", parse_pvd,
     R"(<VTKFile type="Collection"><Collection><DataSet timestep="1s" file="a"/></Collection></VTKFile>)", "\"1s\""},
    {"pvd time NaN", parse_pvd,
     R"(<VTKFile type="Collection"><Collection><DataSet timestep="nan" file="a"/></Collection></VTKFile>)", "finite"},
    {"series empty", parse_series, "", "not well-formed JSON"},
    {"series a list", parse_series, "[]", "no \"files\""},
    {"series files a number", parse_series, R"({"files": 3})", "no \"files\""},
    {"series no files", parse_series, R"({"files": []})", "names no files"},
    {"series name a number", parse_series, R"({"files": [{"name": 3}]})", "no \"name\""},
    {"series name empty", parse_series, R"({"files": [{"name": ""}]})", "empty name"},
    {"series time a word", parse_series, R"({"files": [{"name": "a", "time": "now"}]})", "time of a"},
    {"series nested deeply", parse_series,
     R"({"files": )" + std::string(100'000, '[') + std::string(100'000, ']') + "}", "nested too deeply"},
};

class MalformedIndex : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedIndex, is_refused_by_name) {
    try {
        (void)GetParam().parse(GetParam().text, "dir/x.index");
        FAIL() << GetParam().name << " was accepted";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("dir/x.index: ")) << GetParam().name;
        EXPECT_THAT(error.what(), HasSubstr(GetParam().error)) << GetParam().name;
    }
}

INSTANTIATE_TEST_SUITE_P(table, MalformedIndex, ::testing::ValuesIn(malformed), [](const auto& row) {
    std::string name = row.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

} // namespace
} // namespace server::importer
