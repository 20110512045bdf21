// The picture comparison, on pairs of pictures with a known difference.
#include "support/golden/difference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

Picture plain(int width, int height, std::array<std::uint8_t, 3> color) {
    Picture picture{width, height, {}};
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        picture.rgb.insert(picture.rgb.end(), color.begin(), color.end());
    return picture;
}

void paint(Picture& picture, int left, int top, int width, int height, std::array<std::uint8_t, 3> color) {
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                picture.rgb[3 * static_cast<std::size_t>(y * picture.width + x) + k] = color[k];
}

// L*a*b* values by CIE 15 (D65): white 100, 0, 0; black 0, 0, 0; red 53.24, 80.09, 67.20; (119, 119, 119) 50.03, 0, 0.
TEST(Difference, IsMeasuredInLab) {
    struct Row {
        std::array<std::uint8_t, 3> a, b;
        double distance;
    };
    const Row rows[] = {{{255, 255, 255}, {0, 0, 0}, 100},
                        {{255, 0, 0}, {0, 0, 0}, 117.35},
                        {{119, 119, 119}, {0, 0, 0}, 50.03},
                        {{7, 7, 7}, {7, 7, 7}, 0}};
    for (const Row& row : rows) {
        const Difference found = difference(plain(20, 20, row.a), plain(20, 20, row.b));
        EXPECT_NEAR(found.shift, row.distance, 0.05);
        EXPECT_EQ(found.share, row.distance > Tolerance::color ? 1 : 0);
    }
}

TEST(Difference, FindsWhatIsFaintAndWide) {
    const Picture before = plain(100, 70, {120, 120, 120});
    Picture after = before;
    paint(after, 64, 32, 30, 20, {123, 123, 123});
    const Difference found = difference(before, after);
    EXPECT_GT(found.shift, 1);
    EXPECT_EQ(found.shift_x, 64);
    EXPECT_EQ(found.shift_y, 32);
    EXPECT_EQ(found.share, 0);
    EXPECT_FALSE(is_within(found, {}));
}

TEST(Difference, ForgivesAnEdgeThatIsOnePixelOffButNotTwo) {
    Picture before = plain(320, 320, {120, 120, 120});
    for (const int pixels : {1, 2}) {
        Picture after = before;
        Picture first = before;
        paint(first, 100, 100, 60, 90, {160, 120, 120});
        paint(after, 100 + pixels, 100, 60, 90, {160, 120, 120});
        EXPECT_EQ(difference(first, after).share > 0, pixels == 2);
    }
}

TEST(Difference, FindsWhatVanishedOrAppearedEitherWay) {
    const Picture without = plain(200, 200, {10, 10, 10});
    Picture with = without;
    paint(with, 50, 50, 6, 6, {250, 250, 250});
    for (const Difference& found : {difference(without, with), difference(with, without)}) {
        EXPECT_NEAR(found.share, 36.0 / 40000, 28.0 / 40000);
        EXPECT_FALSE(is_within(found, {}));
    }
}

TEST(Difference, OfTheLastIncompleteTileIsSeenToo) {
    const Picture before = plain(33, 17, {10, 10, 10});
    Picture after = before;
    paint(after, 32, 16, 1, 1, {20, 20, 20});
    const Difference found = difference(before, after);
    EXPECT_EQ(found.shift_x, 32);
    EXPECT_EQ(found.shift_y, 16);
    EXPECT_GT(found.shift, 1);
}

TEST(Difference, OfSizesThatDifferIsRefused) {
    EXPECT_THROW(static_cast<void>(difference(plain(3, 4, {}), plain(4, 3, {}))), std::invalid_argument);
}

TEST(DifferencePicture, IsRedWhereThePicturesDiffer) {
    const Picture before = plain(8, 8, {100, 100, 100});
    Picture after = before;
    paint(after, 2, 3, 1, 1, {130, 130, 130});
    const Picture shown = difference_picture(before, after);
    const std::size_t there = 3 * (3 * 8 + 2);
    EXPECT_GT(shown.rgb[there], shown.rgb[there + 1] + 100);
    EXPECT_EQ(shown.rgb[0], shown.rgb[1]);
}

} // namespace
} // namespace ciel::test
