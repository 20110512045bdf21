// Streamed PNG decodes to the original picture. Streamed JPEG equals that of libjpeg in a single call, once decoded.
#include "ciel/types.hpp"
#include "decode.hpp"
#include "pictures.hpp"
#include "wire/pictures/picture_stream.hpp"

#include <algorithm>
#include <cstdio> // must precede jpeglib.h, which needs FILE
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <jpeglib.h>

namespace server::wire {
using namespace ciel;
namespace {

std::vector<std::uint8_t> jpeg_in_one_go(const Picture& picture) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    std::vector<std::uint8_t> file(4 * picture.rgb.size() + 4096);
    unsigned char* begin = file.data();
    unsigned long size = file.size();
    jpeg_mem_dest(&jpeg, &begin, &size);
    jpeg.image_width = static_cast<JDIMENSION>(picture.width);
    jpeg.image_height = static_cast<JDIMENSION>(picture.height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 80, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < picture.height; ++y) {
        JSAMPROW row = const_cast<JSAMPROW>(picture.rgb.data()) + std::size_t{3} * picture.width * y;
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    file.resize(size);
    return file;
}

Picture filled(int width, int height) {
    Picture picture{"filled", width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x + y, 3 * x, 255 - y}) picture.rgb.push_back(static_cast<std::uint8_t>(value));
    return picture;
}

void paint(Picture& picture, int left, int top, int width, int height, std::uint8_t value) {
    for (int y = top; y < std::min(top + height, picture.height); ++y)
        for (int x = 3 * left; x < 3 * std::min(left + width, picture.width); ++x)
            picture.rgb[std::size_t{3} * picture.width * y + x] = value;
}

class PictureStreams : public testing::TestWithParam<MovingCodec> {
protected:
    std::vector<std::uint8_t> next(const Picture& picture) {
        std::vector<std::uint8_t> file;
        stream_->encode(picture.width, picture.height, picture.rgb, file);
        return file;
    }

    void expect_right(const Picture& picture) {
        const auto file = next(picture);
        const int width = picture.width, height = picture.height;
        const bool is_png = GetParam() == MovingCodec::png;
        EXPECT_EQ(is_png ? decoded_png(file, width, height) : decoded_jpeg(file, width, height),
                  is_png ? picture.rgb : decoded_jpeg(jpeg_in_one_go(picture), width, height))
            << picture.name << ", " << width << " x " << height;
    }

    std::unique_ptr<PictureStream> stream_ = make_picture_stream(GetParam());
};

TEST_P(PictureStreams, EverySizeIsRight) {
    for (const Picture& picture : pictures()) expect_right(picture);
    // JPEG: rows whose number of MCUs is prime, smaller than a piece, or a multiple of the cycle of restart markers.
    for (const int width : {16, 17, 48, 64, 65, 79 * 16, 80 * 16 - 15, 85 * 16, 128})
        for (const int height : {1, 16, 63, 64, 65, 130}) expect_right(filled(width, height));
}

TEST_P(PictureStreams, WhatChangesIsCodedAgain) {
    Picture picture = filled(1280 - 5, 200);
    expect_right(picture);
    std::mt19937 random(11);
    const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
    for (int i = 0; i < 60; ++i) {
        paint(picture, below(picture.width), below(picture.height), 1 + below(200), 1 + below(60),
              static_cast<std::uint8_t>(random()));
        expect_right(picture);
    }
}

TEST_P(PictureStreams, ASinglePixelCounts) {
    Picture picture = filled(200, 100);
    for (const auto& [x, y] : {std::pair{0, 0}, {199, 0}, {0, 99}, {199, 99}, {63, 63}, {64, 64}}) {
        const auto before = next(picture);
        EXPECT_EQ(next(picture), before);
        paint(picture, x, y, 1, 1, 0);
        paint(picture, x + 1, y, 1, 1, 255);
        expect_right(picture);
        EXPECT_NE(next(picture), before);
    }
}

TEST_P(PictureStreams, PicturesAreAppended) {
    const Picture any = pictures().back();
    std::vector<std::uint8_t> behind{1, 2, 3}, expected = behind;
    const auto alone = next(any);
    expected.insert(expected.end(), alone.begin(), alone.end());
    stream_->encode(any.width, any.height, any.rgb, behind);
    EXPECT_EQ(behind, expected);
}

TEST_P(PictureStreams, WrongSizesAreRefusedAndTheNextPictureIsRight) {
    struct Row {
        int width, height;
        std::size_t bytes;
        const char* error;
    };
    expect_right(filled(70, 70));
    for (const Row& row : {Row{0, 5, 0, "0 x 5"}, Row{5, -1, 0, "5 x -1"}, Row{2, 2, 11, "11 bytes"},
                           Row{2, 2, 13, "13 bytes"}, Row{20'000'000, 1, 3 * 20'000'000, "20000000 x 1"}}) {
        const std::vector<std::uint8_t> rgb(row.bytes);
        std::vector<std::uint8_t> out{9};
        EXPECT_THAT([&] { stream_->encode(row.width, row.height, rgb, out); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr(row.error)));
        EXPECT_EQ(out.size(), 1U);
    }
    expect_right(filled(70, 70));
}

INSTANTIATE_TEST_SUITE_P(All, PictureStreams, testing::Values(MovingCodec::png, MovingCodec::jpeg),
                         [](const auto& codec) { return codec.param == MovingCodec::png ? "Png" : "Jpeg"; });

} // namespace
} // namespace server::wire
