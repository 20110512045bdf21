// Wraps libpng: turns its longjmp on an error into an exception.
#pragma once

#include <cstdint>
#include <png.h>
#include <vector>

namespace ciel::wire {

// Calls write(png, info, what) with an 8-bit RGB IHDR of this size set and nothing written. Its output is appended to
// `out`. No object with a destructor may live in `write` during a libpng call. Throws Error with libpng's message.
void write_with_libpng(int width, int height, std::vector<std::uint8_t>& out,
                       void (*write)(png_structp png, png_infop info, const void* what), const void* what);

} // namespace ciel::wire
