// libpng decodes the encoded PNG to the original pixels.
#include "ciel/types.hpp"
#include "decode.hpp"
#include "pictures.hpp"
#include "wire/pictures/png.hpp"
#include "wire/pictures/png_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::wire {
using namespace ciel;
namespace {

TEST(Png, ComesBackPixelForPixel) {
    for (const Picture& picture : pictures()) {
        std::vector<std::uint8_t> still, moving;
        encode_png(picture.width, picture.height, picture.rgb, still);
        EXPECT_EQ(decoded_png(still, picture.width, picture.height), picture.rgb) << picture.name;
        PngStream().encode(picture.width, picture.height, picture.rgb, moving);
        EXPECT_LE(still.size(), moving.size() * 11 / 10) << picture.name;
    }
}

TEST(Png, IsAppended) {
    const Picture any = pictures().back();
    std::vector<std::uint8_t> alone;
    encode_png(any.width, any.height, any.rgb, alone);
    std::vector<std::uint8_t> behind{1, 2, 3}, expected = behind;
    expected.insert(expected.end(), alone.begin(), alone.end());
    encode_png(any.width, any.height, any.rgb, behind);
    EXPECT_EQ(behind, expected);
}

TEST(Png, WrongSizesAreRefused) {
    struct Row {
        int width, height;
        std::size_t bytes;
        const char* error;
    };
    for (const Row& row : {Row{0, 5, 0, "0 x 5"}, Row{5, -1, 0, "5 x -1"}, Row{2, 2, 11, "11 bytes"},
                           Row{2, 2, 13, "13 bytes"}, Row{1 << 30, 1 << 30, 12, "1073741824 x 1073741824"}}) {
        const std::vector<std::uint8_t> rgb(row.bytes);
        std::vector<std::uint8_t> out{9};
        EXPECT_THAT([&] { encode_png(row.width, row.height, rgb, out); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr(row.error)));
        EXPECT_EQ(out.size(), 1U);
    }
}

} // namespace
} // namespace server::wire
