#include "wire/pictures/libpng_file.hpp"

#include "ciel/types.hpp"

#include <csetjmp>
#include <new>
#include <string>

namespace server::wire {
namespace {

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
    png_error(png, "out of memory"); // an exception must not pass through libpng's C functions
}

void keep_error(png_structp png, png_const_charp message) {
    static_cast<Sink*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

} // namespace

void write_with_libpng(int width, int height, std::vector<std::uint8_t>& out,
                       void (*write)(png_structp png, png_infop info, const void* what), const void* what) {
    Sink sink{&out, {}};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, keep_error, ignore_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    volatile bool written = false;
    if (info != nullptr && setjmp(png_jmpbuf(png)) == 0) {
        png_set_write_fn(png, &sink, write_bytes, nullptr);
        png_set_user_limits(png, 1 << 24, 1 << 24);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        write(png, info, what);
        written = true;
    }
    png_destroy_write_struct(&png, &info);
    if (sink.out_of_memory) throw std::bad_alloc();
    if (!written)
        throw ciel::Error("libpng could not write a picture of " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels: " + sink.error);
}

} // namespace server::wire
