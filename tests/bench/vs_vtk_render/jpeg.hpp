// JPEG of quality 80 by libjpeg-turbo, as CIEL codes its moving pictures, but in one go.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::vs_vtk {

// RGBA. Replaces `out`; its memory is used again. The program ends with libjpeg's words where it fails.
void encode_jpeg(int width, int height, std::span<const std::uint8_t> rows_from_bottom, std::vector<std::uint8_t>& out);

} // namespace ciel::vs_vtk
