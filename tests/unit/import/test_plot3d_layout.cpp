#include "ciel/types.hpp"
#include "import/parsers/openfoam/units.hpp"
#include "import/parsers/plot3d_layout.hpp"

#include <algorithm>
#include <cstring>
#include <gmock/gmock.h>

namespace server::importer {
using namespace ciel;
namespace {

std::vector<std::byte> words(std::initializer_list<std::uint32_t> values, bool big_endian) {
    std::vector<std::byte> bytes;
    for (const std::uint32_t value : values)
        for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * (big_endian ? 3 - i : i))));
    return bytes;
}

// Uses the sizes of NASA's sample files. Plot3D files do not state their own layout.
TEST(Plot3dLayout, finds_the_nasa_files) {
    const auto fin = plot3d_binary_layouts(words({40, 32, 32}, true), 491'532, Plot3dKind::grid);
    ASSERT_EQ(fin.size(), 1U);
    EXPECT_TRUE(fin[0].big_endian);
    EXPECT_FALSE(fin[0].iblank || fin[0].byte_counts || fin[0].multi_grid || fin[0].double_precision);
    EXPECT_EQ(fin[0].points(0), 40'960U);

    const auto padded = plot3d_binary_layouts(words({40, 32, 32}, true), 819'712, Plot3dKind::solution);
    ASSERT_EQ(padded.size(), 1U);
    EXPECT_TRUE(plot3d_match(fin[0], padded[0]));

    const auto post = plot3d_binary_layouts(words({38, 76, 38}, true), 1'755'916, Plot3dKind::grid);
    ASSERT_EQ(post.size(), 1U);
    EXPECT_TRUE(post[0].iblank);
}

TEST(Plot3dLayout, a_size_that_is_off_by_one_fits_nothing) {
    for (const int off : {-1, 1})
        EXPECT_TRUE(
            plot3d_binary_layouts(words({40, 32, 32}, true), std::uint64_t(491'532 + off), Plot3dKind::grid).empty());
}

TEST(Plot3dLayout, dimensions_whose_product_overflows_are_no_layout) {
    for (const bool big : {false, true}) {
        EXPECT_TRUE(plot3d_binary_layouts(words({0x80000000U, 0x80000000U, 4}, big), 12, Plot3dKind::grid).empty());
        EXPECT_TRUE(plot3d_binary_layouts(words({0, 0, 0}, big), 12, Plot3dKind::grid).empty());
    }
}

TEST(Plot3dLayout, records_must_have_their_lengths) {
    const std::uint64_t size = 8 + 12 + 8 + 8 * 12;
    EXPECT_EQ(plot3d_binary_layouts(words({12, 2, 2, 2, 12}, false), size, Plot3dKind::grid).size(), 1U);
    EXPECT_TRUE(plot3d_binary_layouts(words({12, 2, 2, 2, 13}, false), size, Plot3dKind::grid).empty());
}

TEST(Plot3dLayout, text_is_told_by_the_count_of_its_numbers) {
    EXPECT_EQ(plot3d_text_layouts("2 2 2 0.0", 3 + 24, Plot3dKind::grid).size(), 1U);
    EXPECT_TRUE(plot3d_text_layouts("2 2 2 0.0", 3 + 32, Plot3dKind::grid).at(0).iblank);
    EXPECT_TRUE(plot3d_text_layouts("1\n2 2 2 0.0", 4 + 24, Plot3dKind::grid).at(0).multi_grid);
    EXPECT_TRUE(plot3d_text_layouts("2 2", 2, Plot3dKind::grid).empty());
}

TEST(Plot3dLayout, words_choose_among_what_fits) {
    std::vector<Plot3dLayout> two(2);
    two[1].big_endian = true;
    EXPECT_TRUE(plot3d_restrict(two, "big,stream").at(0).big_endian);
    EXPECT_EQ(plot3d_restrict(two, "").size(), 2U);
    EXPECT_TRUE(plot3d_restrict(two, "records").empty());
    EXPECT_THROW((void)plot3d_restrict(two, "big,,little"), Error);
}

TEST(OpenFoamUnits, are_those_of_the_dimensions_entry) {
    struct {
        const char* text;
        const char* units;
    } const rows[] = {
        {"dimensions      [0 1 -1 0 0 0 0];", "m/s"},
        {"dimensions [1 -1 -2 0 0 0 0];", "Pa"},
        {"dimensions [0 2 -2 0 0 0 0];", "m^2/s^2"},
        {"dimensions [1 -3 0 0 0];", "kg/m^3"},
        {"dimensions [0 2 -2 -1 0 0 0];", "m^2/(s^2 K)"},
        {"dimensions [0 0 -1 0 0 0 0];", "1/s"},
        {"dimensions [0 0 0 0 0 0 0];", ""},
        {"// dimensionsOf\ndimensions [0 0 0 1 0 0 0];", "K"},
        {"mydimensions [0 1 0 0 0 0 0];", ""},
        {"dimensions [0 1", ""},
        {"dimensions [m s];", ""},
        {"dimensions [0 0.5 0 0 0 0 0];", ""},
        {"", ""},
    };
    for (const auto& row : rows) EXPECT_EQ(openfoam_units(row.text), row.units) << row.text;
}

} // namespace
} // namespace server::importer
