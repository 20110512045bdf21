// Encodes a JPEG of quality 80 with libjpeg-turbo in one call. CIEL uses the same quality for moving pictures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::vs_vtk {

// Rows are RGBA. Replaces the content of `out` and reuses its memory. An error of libjpeg ends the program.
void encode_jpeg(int width, int height, std::span<const std::uint8_t> rows_from_bottom, std::vector<std::uint8_t>& out);

} // namespace ciel::vs_vtk
