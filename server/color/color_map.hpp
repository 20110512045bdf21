// Named color maps; the same table serves the browser's legend through protocol/colormaps.json.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ciel::color {

using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>; // sRGB, from the lowest value to the highest

[[nodiscard]] const std::vector<std::string>& color_map_names();
[[nodiscard]] std::size_t color_map_index(const std::string& name); // throws Error that lists the names
[[nodiscard]] const ColorTable& color_map(const std::string& name); // likewise

} // namespace ciel::color
