#include "vs_vtk_render/jpeg.hpp"

#include <cstdio> // before jpeglib.h, which needs FILE
#include <jpeglib.h>

namespace ciel::vs_vtk {

namespace {

struct Rows {
    const std::uint8_t* first; // from the top
    std::ptrdiff_t step;       // bytes from one to the next
    J_COLOR_SPACE colors;
    int components;
};

void encode(int width, int height, const Rows& rows, std::vector<std::uint8_t>& out) {
    constexpr int quality = 80;
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    out.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)); // more than it can need
    unsigned char* begin = out.data();
    unsigned long size = out.size();
    jpeg_mem_dest(&jpeg, &begin, &size);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = rows.components;
    jpeg.in_color_space = rows.colors;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    for (int row = 0; row < height; ++row) {
        JSAMPROW line = const_cast<JSAMPROW>(rows.first + row * rows.step); // libjpeg only reads it
        jpeg_write_scanlines(&jpeg, &line, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    out.resize(size);
}

} // namespace

void encode_jpeg_of_rgb(int width, int height, std::span<const std::uint8_t> rows_from_top,
                        std::vector<std::uint8_t>& out) {
    encode(width, height, {rows_from_top.data(), 3 * std::ptrdiff_t{width}, JCS_RGB, 3}, out);
}

void encode_jpeg_of_rgba(int width, int height, std::span<const std::uint8_t> rows_from_bottom,
                         std::vector<std::uint8_t>& out) {
    const std::ptrdiff_t row = 4 * std::ptrdiff_t{width};
    encode(width, height, {rows_from_bottom.data() + (height - 1) * row, -row, JCS_EXT_RGBX, 4}, out);
}

} // namespace ciel::vs_vtk
