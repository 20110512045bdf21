// Wraps libpng: turns its longjmp on an error into an exception.
#pragma once

#include <cstdint>
#include <png.h>
#include <vector>

namespace server::wire {

// Calls write(png, info, what) after IHDR (8-bit RGB). No object with a destructor may exist in `write` during a libpng
// call. Throws Error with the message of libpng, or std::bad_alloc.
void write_with_libpng(int width, int height, std::vector<std::uint8_t>& out,
                       void (*write)(png_structp png, png_infop info, const void* what), const void* what);

} // namespace server::wire
