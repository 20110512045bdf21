// Named colour maps; the same table serves the browser's legend through protocol/colormaps.json.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ciel::render {

using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>; // sRGB

[[nodiscard]] const std::vector<std::string>& color_map_names();
[[nodiscard]] const ColorTable& color_map(const std::string& name); // throws Error with the names that exist

} // namespace ciel::render
