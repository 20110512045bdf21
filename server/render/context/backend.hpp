// The libraries and platforms that can provide OpenGL.
#pragma once

#include <string>

namespace ciel::render {

// Back ends in the order in which `automatic` tries them. Of EGL devices, hardware comes before software.
enum class Backend { automatic, egl_device, egl_surfaceless, osmesa };

[[nodiscard]] const char* name_of(Backend backend);
[[nodiscard]] Backend
backend_named(const std::string& name); // "auto", "egl-device", "egl-surfaceless", "osmesa"; others throw Error

} // namespace ciel::render
