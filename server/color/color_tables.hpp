// The tables of protocol/colormaps.json, compiled in by CMake (color_tables.cmake).
#pragma once

#include <span>
#include <string_view>

namespace server::color {

struct NamedColors {
    std::string_view name;
    std::string_view kind;   // sequential, diverging or cyclic
    std::string_view colors; // 256 x RRGGBB in hexadecimal
};
[[nodiscard]] std::span<const NamedColors> color_tables();

} // namespace server::color
