// libpng, which leaves an error by longjmp, behind a function that throws.
#pragma once

#include <cstdint>
#include <png.h>
#include <vector>

namespace ciel::wire {

// Calls write(png, info, what) with an 8-bit RGB IHDR of this size set and nothing written; what it writes is appended
// to `out`. Nothing with a destructor may live in `write` while libpng is called. Throws Error with libpng's words.
void write_with_libpng(int width, int height, std::vector<std::uint8_t>& out,
                       void (*write)(png_structp png, png_infop info, const void* what), const void* what);

} // namespace ciel::wire
