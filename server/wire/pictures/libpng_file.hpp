// Wraps libpng: turns its longjmp on an error into an exception.
#pragma once

#include <cstdint>
#include <png.h>
#include <vector>

namespace ciel::wire {

// Sets an 8-bit RGB IHDR of this size, then calls write(png, info, what), which writes the file. The output of libpng
// is appended to `out`. No object with a destructor may exist in `write` during a libpng call. Throws Error with the
// message of libpng, or std::bad_alloc if memory runs out.
void write_with_libpng(int width, int height, std::vector<std::uint8_t>& out,
                       void (*write)(png_structp png, png_infop info, const void* what), const void* what);

} // namespace ciel::wire
