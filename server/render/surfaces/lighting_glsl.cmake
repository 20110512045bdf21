# Writes protocol/lighting.glsl, which the web page uses too, into lighting_glsl.cpp of this library.
set(lighting ${CMAKE_SOURCE_DIR}/protocol/lighting.glsl)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${lighting})
file(READ ${lighting} formulas)
set(CIEL_LIGHTING_GLSL ${CMAKE_CURRENT_BINARY_DIR}/lighting_glsl.cpp)
file(CONFIGURE OUTPUT ${CIEL_LIGHTING_GLSL} @ONLY CONTENT [[
#include "render/surfaces/lighting_glsl.hpp"

namespace ciel::render {

const char* const lighting_glsl = R"(
@formulas@)";

} // namespace ciel::render
]])
