// What libpng decodes is what was encoded, pixel for pixel.
#include "ciel/types.hpp"
#include "pictures.hpp"
#include "wire/png.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

namespace ciel::wire {
namespace {

std::vector<std::uint8_t> decoded(const std::vector<std::uint8_t>& png, int width, int height) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0) << image.message;
    EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
    EXPECT_EQ(image.width, static_cast<png_uint_32>(width));
    EXPECT_EQ(image.height, static_cast<png_uint_32>(height));
    std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0) << image.message;
    return rgb;
}

TEST(Png, ComesBackPixelForPixel) {
    for (const Picture& picture : pictures()) {
        std::size_t interactive_bytes = 0;
        for (const PngEffort effort : {PngEffort::interactive, PngEffort::still}) {
            std::vector<std::uint8_t> png;
            encode_png(picture.width, picture.height, picture.rgb, effort, png);
            EXPECT_EQ(decoded(png, picture.width, picture.height), picture.rgb) << picture.name;
            if (effort == PngEffort::interactive)
                interactive_bytes = png.size();
            else
                EXPECT_LE(png.size(), interactive_bytes * 11 / 10 + 64) << picture.name;
        }
    }
}

TEST(Png, IsAppended) {
    const Picture any = pictures().back();
    std::vector<std::uint8_t> alone;
    encode_png(any.width, any.height, any.rgb, PngEffort::interactive, alone);
    std::vector<std::uint8_t> behind{1, 2, 3}, expected = behind;
    expected.insert(expected.end(), alone.begin(), alone.end());
    encode_png(any.width, any.height, any.rgb, PngEffort::interactive, behind);
    EXPECT_EQ(behind, expected);
}

TEST(Png, WrongSizesAreRefused) {
    struct Row {
        int width, height;
        std::size_t bytes;
        const char* error;
    };
    for (const Row& row : {Row{0, 5, 0, "0 x 5"}, Row{5, -1, 0, "5 x -1"}, Row{2, 2, 11, "11 bytes"},
                           Row{2, 2, 13, "13 bytes"}, Row{1 << 30, 1 << 30, 12, "12 bytes"}}) {
        const std::vector<std::uint8_t> rgb(row.bytes);
        std::vector<std::uint8_t> out{9};
        EXPECT_THAT([&] { encode_png(row.width, row.height, rgb, PngEffort::interactive, out); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr(row.error)));
        EXPECT_EQ(out.size(), 1U);
    }
}

} // namespace
} // namespace ciel::wire
