// PNG (ISO/IEC 15948) by libpng.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

enum class PngEffort { interactive, still }; // level 1 + SUB + run lengths against libpng's own choices at level 6

// rgb: rows from the top, 3 bytes a pixel. Appends to `out`. Throws Error when sizes do not agree.
void encode_png(int width, int height, std::span<const std::uint8_t> rgb, PngEffort effort,
                std::vector<std::uint8_t>& out);

} // namespace ciel::wire
