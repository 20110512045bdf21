// Named color maps of protocol/colormaps.json.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace server::color {

using ColorTable = std::array<std::array<std::uint8_t, 3>, 256>; // sRGB, from the lowest value to the highest

[[nodiscard]] const std::vector<std::string>& color_map_names();
// The next two functions throw Error if there is no map `name`. The text of the error lists all names.
[[nodiscard]] std::size_t color_map_index(const std::string& name);
[[nodiscard]] const ColorTable& color_map(const std::string& name);

} // namespace server::color
