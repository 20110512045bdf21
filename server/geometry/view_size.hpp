// The size of a view in pixels.
#pragma once

#include <cstdint>

namespace server::geometry {

struct ViewSize {
    std::uint32_t width = 0, height = 0;
    double pixel_ratio = 1; // pixels per unit of line width and point size
};

} // namespace server::geometry
