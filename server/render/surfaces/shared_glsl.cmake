# Writes the contents of protocol/shading/*.glsl into shared_glsl.cpp of this library. The web page uses the same files.
set(CIEL_SHARED_GLSL ${CMAKE_CURRENT_BINARY_DIR}/shared_glsl.cpp)
foreach(name color_scale depth_layers lighting)
  set(text ${CMAKE_SOURCE_DIR}/protocol/shading/${name}.glsl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${text})
  file(READ ${text} ${name})
endforeach()
file(CONFIGURE OUTPUT ${CIEL_SHARED_GLSL} @ONLY CONTENT [[
#include "render/surfaces/shared_glsl.hpp"

namespace server::render {

const char* const color_scale_glsl = R"(
@color_scale@)";

const char* const depth_layers_glsl = R"(
@depth_layers@)";

const char* const lighting_glsl = R"(
@lighting@)";

} // namespace server::render
]])
