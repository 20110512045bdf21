#include "decode.hpp"

#include "wire/frame_header.hpp"

#include <cstdio> // must precede jpeglib.h, which needs FILE
#include <gtest/gtest.h>
#include <jpeglib.h>
#include <png.h>

namespace server::wire {

std::vector<std::uint8_t> joined(std::span<const std::vector<std::uint8_t>> messages) {
    std::vector<std::uint8_t> whole;
    for (const auto& message : messages) {
        const FrameHeader header = read_frame_header(message);
        EXPECT_LE(message.size(), longest_message);
        EXPECT_EQ(header.piece_offset, whole.size());
        whole.insert(whole.end(), message.begin() + frame_header_bytes, message.end());
        EXPECT_EQ(whole.size() == header.whole_bytes, &message == &messages.back());
    }
    return whole;
}

std::vector<std::uint8_t> decoded_png(const std::vector<std::uint8_t>& file, int width, int height) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0) << image.message;
    EXPECT_EQ(image.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
    EXPECT_EQ(image.width, static_cast<png_uint_32>(width));
    EXPECT_EQ(image.height, static_cast<png_uint_32>(height));
    std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0) << image.message;
    EXPECT_EQ(image.warning_or_error, 0U) << image.message;
    return rgb;
}

// An error of libjpeg prints its message and ends the program.
std::vector<std::uint8_t> decoded_jpeg(const std::vector<std::uint8_t>& file, int width, int height) {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, file.data(), file.size());
    jpeg_read_header(&jpeg, TRUE);
    jpeg_start_decompress(&jpeg);
    EXPECT_EQ(jpeg.output_width, static_cast<JDIMENSION>(width));
    EXPECT_EQ(jpeg.output_height, static_cast<JDIMENSION>(height));
    EXPECT_EQ(jpeg.output_components, 3);
    const std::size_t stride = 3 * std::size_t{jpeg.output_width};
    std::vector<std::uint8_t> rgb(stride * jpeg.output_height);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW row = rgb.data() + stride * jpeg.output_scanline;
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    EXPECT_EQ(errors.num_warnings, 0); // markers out of order are reported as warnings
    EXPECT_EQ(jpeg.src->bytes_in_buffer, 0U);
    jpeg_destroy_decompress(&jpeg);
    return rgb;
}

} // namespace server::wire
