#include "ciel/types.hpp"
#include "color/color_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::color {
using namespace ciel;
namespace {

using Color = std::array<std::uint8_t, 3>;

// First, middle and last color of each map, as published by its authors.
struct Row {
    std::string name;
    Color first, middle, last;
};
const Row rows[] = {
    {"viridis", {68, 1, 84}, {33, 145, 140}, {253, 231, 37}},
    {"inferno", {0, 0, 4}, {188, 55, 84}, {252, 255, 164}},
    {"plasma", {13, 8, 135}, {204, 71, 120}, {240, 249, 33}},
    {"magma", {0, 0, 4}, {183, 55, 121}, {252, 253, 191}},
    {"cividis", {0, 34, 78}, {125, 124, 120}, {254, 232, 56}},
    {"turbo", {48, 18, 59}, {164, 252, 60}, {122, 4, 3}},
    {"coolwarm", {59, 76, 192}, {221, 220, 220}, {180, 4, 38}},
    {"RdBu", {103, 0, 31}, {247, 247, 247}, {5, 48, 97}},
    {"grayscale", {0, 0, 0}, {128, 128, 128}, {255, 255, 255}},
    {"batlow", {1, 25, 89}, {130, 130, 49}, {250, 204, 250}},
    {"hawaii", {140, 2, 115}, {156, 150, 28}, {179, 242, 253}},
    {"lajolla", {255, 255, 204}, {222, 116, 79}, {26, 26, 1}},
    {"oslo", {1, 1, 1}, {80, 123, 188}, {255, 255, 255}},
    {"thermal", {4, 35, 51}, {178, 96, 129}, {232, 250, 91}},
    {"haline", {42, 24, 108}, {60, 148, 135}, {253, 239, 154}},
    {"vik", {0, 18, 97}, {236, 229, 223}, {89, 0, 8}},
    {"roma", {126, 23, 0}, {191, 234, 196}, {3, 49, 152}},
    {"berlin", {158, 176, 255}, {25, 12, 9}, {255, 173, 173}},
    {"balance", {24, 28, 67}, {240, 235, 234}, {60, 9, 18}},
    {"PuOr", {127, 59, 8}, {247, 247, 247}, {45, 0, 75}},
    {"BrBG", {84, 48, 5}, {245, 245, 245}, {0, 60, 48}},
    {"romaO", {115, 57, 87}, {203, 225, 179}, {114, 57, 89}},
    {"twilight", {226, 217, 226}, {48, 20, 54}, {226, 217, 226}},
};

TEST(ColorMap, HasThePublishedColors) {
    for (const Row& row : rows) {
        const color::ColorTable& table = color::color_map(row.name);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(table.front()[k], row.first[k], 1) << row.name;
            EXPECT_NEAR(table[128][k], row.middle[k], 2) << row.name;
            EXPECT_NEAR(table.back()[k], row.last[k], 1) << row.name;
        }
    }
    EXPECT_EQ(color::color_map_names().size(), std::size(rows));
}

// A wrong digit in the table would be a jump.
TEST(ColorMap, StepsAreSmallEverywhere) {
    for (const std::string& name : color::color_map_names()) {
        const color::ColorTable& table = color::color_map(name);
        for (std::size_t i = 1; i < table.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_LE(std::abs(table[i][k] - table[i - 1][k]), 9) << name << ' ' << i;
    }
}

TEST(ColorMap, UnknownNameIsRefusedWithTheKnownOnes) {
    EXPECT_THAT(
        [] { static_cast<void>(color::color_map("jet")); },
        testing::ThrowsMessage<Error>(testing::AllOf(testing::HasSubstr("'jet'"), testing::HasSubstr("viridis"))));
}

} // namespace
} // namespace server::color
