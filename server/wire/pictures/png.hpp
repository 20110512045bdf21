// Encodes pictures as PNG (ISO/IEC 15948) with libpng, optimized for size: for still pictures and files.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace server::wire {

// `rgb`: rows from the top, 3 bytes per pixel. Throws Error if the sizes do not match.
void encode_png(int width, int height, std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& out);

} // namespace server::wire
