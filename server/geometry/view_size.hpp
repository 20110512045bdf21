#pragma once

#include <cstdint>

namespace ciel::geometry {

struct ViewSize {
    std::uint32_t width = 0, height = 0;
    double pixel_ratio = 1; // so many pixels are one of the widths of lines and points
};

} // namespace ciel::geometry
