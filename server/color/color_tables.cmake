# Generates color_tables.cpp from protocol/colormaps.json.
if(NOT CIEL_COLORMAPS)
  set(CIEL_COLORMAPS ${CMAKE_SOURCE_DIR}/protocol/colormaps.json)
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CIEL_COLORMAPS})
file(READ ${CIEL_COLORMAPS} document)
string(JSON count LENGTH "${document}" maps)
math(EXPR last "${count} - 1")
set(rows "")
foreach(i RANGE ${last})
  string(JSON name GET "${document}" maps ${i} name)
  string(JSON kind GET "${document}" maps ${i} kind)
  string(JSON colors GET "${document}" maps ${i} colors)
  string(APPEND rows "    {\"${name}\", \"${kind}\", \"${colors}\"},\n")
endforeach()
set(CIEL_COLOR_TABLES ${CMAKE_CURRENT_BINARY_DIR}/color_tables.cpp)
file(CONFIGURE OUTPUT ${CIEL_COLOR_TABLES} @ONLY CONTENT [[
#include "color/color_tables.hpp"

namespace server::color {
namespace {
constexpr NamedColors tables[] = {
@rows@};
} // namespace

std::span<const NamedColors> color_tables() { return tables; }

} // namespace server::color
]])
