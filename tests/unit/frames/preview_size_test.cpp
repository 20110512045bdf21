#include "frames/preview_size.hpp"

#include <gtest/gtest.h>

namespace server::frames {
namespace {

constexpr geometry::ViewSize usual{1280, 720}, large{2560, 1440}, small{320, 240};

TEST(PreviewSize, IsThatOfTheViewUpToALimit) {
    const PreviewSize preview;
    EXPECT_DOUBLE_EQ(preview.scale(small), 1);
    EXPECT_DOUBLE_EQ(preview.scale(usual), 1);
    EXPECT_DOUBLE_EQ(preview.scale(large), 0.5);
}

TEST(PreviewSize, IsHalvedTwiceWherePicturesStaySlow) {
    PreviewSize preview;
    preview.took(large, 900);
    EXPECT_DOUBLE_EQ(preview.scale(large), 0.5) << "programs may have been compiled";
    preview.took(large, 900);
    EXPECT_DOUBLE_EQ(preview.scale(large), 0.25);
    for (int i = 0; i < 9; ++i) preview.took(large, 900);
    EXPECT_DOUBLE_EQ(preview.scale(large), 0.125);
}

TEST(PreviewSize, GrowsAgainWhenTheLargerWouldBeFastEnough) {
    PreviewSize preview;
    for (int i = 0; i < 4; ++i) preview.took(usual, 900);
    EXPECT_DOUBLE_EQ(preview.scale(usual), 0.25);
    preview.took(usual, 80);
    EXPECT_DOUBLE_EQ(preview.scale(usual), 0.25) << "four times 80 is too slow";
    preview.took(usual, 70);
    EXPECT_DOUBLE_EQ(preview.scale(usual), 0.5);
    preview.took(usual, 10);
    EXPECT_DOUBLE_EQ(preview.scale(usual), 1);
}

TEST(PreviewSize, OfASmallViewIsItsOwn) {
    PreviewSize preview;
    for (int i = 0; i < 9; ++i) preview.took(small, 900);
    EXPECT_DOUBLE_EQ(preview.scale(small), 1);
}

} // namespace
} // namespace server::frames
