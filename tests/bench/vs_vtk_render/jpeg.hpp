// JPEG of quality 80 by libjpeg-turbo, for both sides of a bench.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::vs_vtk {

// Replaces `out`; its memory is used again. The program ends with libjpeg's words where it fails.
void encode_jpeg_of_rgb(int width, int height, std::span<const std::uint8_t> rows_from_top,
                        std::vector<std::uint8_t>& out);
void encode_jpeg_of_rgba(int width, int height, std::span<const std::uint8_t> rows_from_bottom,
                         std::vector<std::uint8_t>& out);

} // namespace ciel::vs_vtk
