#include "ciel/types.hpp"
#include "render/color_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::render {
namespace {

using Color = std::array<std::uint8_t, 3>;

// First, middle and last colours as their authors published them.
struct Row {
    const char* name;
    Color first, middle, last;
};
const Row rows[] = {
    {"viridis", {68, 1, 84}, {33, 145, 140}, {253, 231, 37}},   {"inferno", {0, 0, 4}, {188, 55, 84}, {252, 255, 164}},
    {"plasma", {13, 8, 135}, {204, 71, 120}, {240, 249, 33}},   {"magma", {0, 0, 4}, {183, 55, 121}, {252, 253, 191}},
    {"cividis", {0, 34, 78}, {125, 124, 120}, {254, 232, 56}},  {"turbo", {48, 18, 59}, {164, 252, 60}, {122, 4, 3}},
    {"coolwarm", {59, 76, 192}, {221, 220, 220}, {180, 4, 38}}, {"RdBu", {103, 0, 31}, {247, 247, 247}, {5, 48, 97}},
    {"grayscale", {0, 0, 0}, {128, 128, 128}, {255, 255, 255}},
};

TEST(ColorMap, HasThePublishedColours) {
    for (const Row& row : rows) {
        const ColorTable& table = color_map(row.name);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(table.front()[k], row.first[k], 1) << row.name;
            EXPECT_NEAR(table[128][k], row.middle[k], 2) << row.name;
            EXPECT_NEAR(table.back()[k], row.last[k], 1) << row.name;
        }
    }
    EXPECT_EQ(color_map_names().size(), std::size(rows));
}

TEST(ColorMap, StepsAreSmallEverywhere) { // a digit lost in the table would be a jump
    for (const std::string& name : color_map_names()) {
        const ColorTable& table = color_map(name);
        for (std::size_t i = 1; i < table.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LE(std::abs(table[i][k] - table[i - 1][k]), 9) << name << ' ' << i;
    }
}

TEST(ColorMap, UnknownNameIsRefusedWithTheKnownOnes) {
    EXPECT_THAT(
        [] { static_cast<void>(color_map("jet")); },
        testing::ThrowsMessage<Error>(testing::AllOf(testing::HasSubstr("'jet'"), testing::HasSubstr("viridis"))));
}

} // namespace
} // namespace ciel::render
