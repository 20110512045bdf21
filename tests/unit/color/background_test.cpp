// Whether text on a background is dark.
#include "color/background.hpp"

#include <gtest/gtest.h>

namespace server::color {
namespace {

TEST(Background, IsBrightIfItsMiddleIs) {
    EXPECT_FALSE(is_bright(dark_background));
    EXPECT_TRUE(is_bright(light_background));
    EXPECT_TRUE(is_bright({{1, 1, 1}, {0, 0, 0}}));
    EXPECT_FALSE(is_bright({{0.9F, 0.9F, 0.9F}, {0, 0, 0}}));
}

TEST(Background, IsBrighterInGreenThanInBlue) {
    EXPECT_TRUE(is_bright({{0, 1, 0}, {0, 1, 0}}));
    EXPECT_FALSE(is_bright({{0, 0, 1}, {0, 0, 1}}));
    EXPECT_FALSE(is_bright({{1, 0, 0}, {1, 0, 0}}));
}

} // namespace
} // namespace server::color
