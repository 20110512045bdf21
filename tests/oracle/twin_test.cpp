// The twin against examples worked out by hand, and against properties of any cut.
#include "oracle/twin/twin.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <regex>

namespace ciel::test {
namespace {

std::vector<CutPolygon> polygons_of(const Polyhedra& mesh, const std::vector<float>& values, double nu) {
    return cut_every_cell(mesh, values, nu).polygons;
}

// Vertices of the unit cube are numbered by bits: 1 for x, 2 for y, 4 for z.
TEST(Twin, CutsACubeAcross) {
    const std::vector<float> up{0, 0, 0, 0, 1, 1, 1, 1};
    // Counter-clockwise seen from above, where the values are higher.
    const CutPolygon expected{0, {{0, 4}, {1, 5}, {3, 7}, {2, 6}}};
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), up, 0.5), std::vector{expected});
}

TEST(Twin, AHighCornerIsIsolatedWithItsNormalTowardsIt) {
    const std::vector<float> corner{0, 0, 0, 0, 0, 0, 0, 1};
    // (3,7) is below vertex 7, (5,7) beside it in y, (6,7) beside it in x. This order is counter-clockwise seen from
    // (1,1,1).
    const CutPolygon expected{0, {{3, 7}, {6, 7}, {5, 7}}};
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), corner, 0.5), std::vector{expected});
}

TEST(Twin, TwoHighCornersOnADiagonalAreTwoPolygons) {
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), {1, 0, 0, 1, 0, 0, 0, 0}, 0.5).size(), 2U);
    // The complement: on ambiguous faces the high vertices are separated, so the low ones are joined.
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), {0, 1, 1, 0, 1, 1, 1, 1}, 0.5).size(), 1U);
}

TEST(Twin, AValueThatHitsAVertexPutsItOnTheHighSide) {
    const std::vector<float> x{0, 1, 0, 1, 0, 1, 0, 1};
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), x, 1.0).size(), 1U);
    EXPECT_EQ(polygons_of(hexahedra({{1, 1, 1}}), x, 0.0).size(), 0U);
}

TEST(Twin, AllTwoHundredAndFiftySixSignsOfACubeAreClosed) {
    const Polyhedra cube = hexahedra({{1, 1, 1}});
    for (int signs = 0; signs < 256; ++signs) {
        std::vector<float> values;
        for (int corner = 0; corner < 8; ++corner) values.push_back(static_cast<float>(signs >> corner & 1));
        const Cut cut = cut_every_cell(cube, values, 0.5);
        EXPECT_EQ(open_segment(polygon_segments(cut.polygons), boundary_segments(cube, values, 0.5)), "") << signs;
        std::size_t corners = 0;
        for (const CutPolygon& polygon : cut.polygons) corners += polygon.edges.size();
        EXPECT_EQ(corners, cut.active_edges.size()) << signs; // every active edge of a cell is in one polygon, once
    }
}

class TwinOnMeshes : public testing::TestWithParam<NamedMesh> {};

TEST_P(TwinOnMeshes, LeavesNoOpenSegment) {
    const Polyhedra mesh = GetParam().make();
    for (const NamedField& field : all_fields()) {
        const std::vector<float> values = field.make(mesh);
        for (double nu : walk_through(values, 4, 41)) {
            const Cut cut = cut_every_cell(mesh, values, nu);
            EXPECT_EQ(open_segment(polygon_segments(cut.polygons), boundary_segments(mesh, values, nu)), "")
                << field.name << " at " << nu;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, TwinOnMeshes, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// The build keeps server/ out of the twin's include folders. This test also finds relative paths.
TEST(Twin, IncludesNoHeaderOfTheKernel) {
    const std::filesystem::path tests = std::filesystem::path(CIEL_SOURCE_DIR) / "tests";
    const std::set<std::string> for_its_tests{
        "views.hpp",          "boundary.hpp",       "thread_count.hpp",    "chosen_algorithm.hpp",
        "copied_records.hpp", "mapped_records.hpp", "volume_property.hpp", "kept.hpp"};
    const std::regex kernel(
        R"(^\s*#\s*include\s*["<](.*/)?((server|ciel)/|)"
        R"((views|boundary|thread_count|chosen_algorithm|copied_records|mapped_records|volume_property|kept)\.hpp))");
    int files = 0;
    for (const auto& folder : {tests / "oracle" / "twin", tests / "support"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (for_its_tests.contains(entry.path().filename())) continue;
            std::ifstream file(entry.path());
            for (std::string line; std::getline(file, line);) {
                EXPECT_FALSE(std::regex_search(line, kernel)) << entry.path() << ": " << line;
            }
            ++files;
        }
    }
    EXPECT_GT(files, 8);
}

} // namespace
} // namespace ciel::test
