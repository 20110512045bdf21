#include "wire/png.hpp"

#include "ciel/types.hpp"

#include <csetjmp>
#include <new>
#include <png.h>
#include <string>
#include <zlib.h>

namespace ciel::wire {
namespace {

// libpng leaves an error by longjmp; nothing with a destructor may live between setjmp and it.
struct Sink {
    std::vector<std::uint8_t>* out;
    std::string error;
    bool out_of_memory = false;
};

void write_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    auto& sink = *static_cast<Sink*>(png_get_io_ptr(png));
    try {
        sink.out->insert(sink.out->end(), bytes, bytes + count);
        return;
    } catch (const std::bad_alloc&) {
        sink.out_of_memory = true;
    }
    png_error(png, "out of memory"); // an exception must not pass through C frames
}

void keep_error(png_structp png, png_const_charp message) {
    static_cast<Sink*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void configure(png_structp png, PngEffort effort) {
    png_set_compression_buffer_size(png, 1 << 16);
    if (effort == PngEffort::still) {
        png_set_compression_level(png, 6);
        return;
    }
    // Run lengths beat level 1's matches on frames, in time and in size: 3 to 10 % each on surfaces and slices.
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
}

bool write_rows(png_structp png, png_infop info, int width, int height, const std::uint8_t* rgb, PngEffort effort) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_user_limits(png, 1 << 24, 1 << 24);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    configure(png, effort);
    png_write_info(png, info);
    const std::size_t stride = 3 * static_cast<std::size_t>(width);
    for (int row = 0; row < height; ++row) png_write_row(png, rgb + static_cast<std::size_t>(row) * stride);
    png_write_end(png, info);
    return true;
}

} // namespace

void encode_png(int width, int height, std::span<const std::uint8_t> rgb, PngEffort effort,
                std::vector<std::uint8_t>& out) {
    const auto size = std::to_string(width) + " x " + std::to_string(height);
    if (width <= 0 || height <= 0) throw Error("a picture of " + size + " pixels cannot be written as PNG");
    if (rgb.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        throw Error("a picture of " + size + " pixels has " + std::to_string(rgb.size()) +
                    " bytes instead of 3 a pixel");
    }
    Sink sink{&out, {}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, keep_error, ignore_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool written = false;
    if (info != nullptr) {
        png_set_write_fn(png, &sink, write_bytes, nullptr);
        written = write_rows(png, info, width, height, rgb.data(), effort);
    }
    png_destroy_write_struct(&png, &info);
    if (sink.out_of_memory) throw std::bad_alloc();
    if (!written) throw Error("libpng could not write a picture of " + size + " pixels: " + sink.error);
}

} // namespace ciel::wire
