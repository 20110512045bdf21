#include "wire/pictures/png.hpp"

#include "wire/pictures/libpng_file.hpp"
#include "wire/pictures/picture_stream.hpp"

namespace server::wire {
namespace {

constexpr int level = 6;

struct Rows {
    const std::uint8_t* first;
    std::size_t stride, count;
};

void write_rows(png_structp png, png_infop info, const void* what) {
    const Rows& rows = *static_cast<const Rows*>(what);
    png_set_compression_buffer_size(png, 1 << 16);
    png_set_compression_level(png, level);
    png_write_info(png, info);
    for (std::size_t row = 0; row < rows.count; ++row) png_write_row(png, rows.first + row * rows.stride);
    png_write_end(png, info);
}

} // namespace

void encode_png(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out) {
    check_picture("PNG", 1 << 24, width, height, rgb);
    const Rows rows{rgb.data(), 3 * static_cast<std::size_t>(width), static_cast<std::size_t>(height)};
    write_with_libpng(width, height, out, write_rows, &rows);
}

} // namespace server::wire
