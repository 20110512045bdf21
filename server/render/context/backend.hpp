// The libraries and platforms that can provide OpenGL.
#pragma once

#include <string>

namespace ciel::render {

// In the order in which `automatic` tries them; hardware devices come before software ones.
enum class Backend { automatic, egl_device, egl_surfaceless, osmesa };

[[nodiscard]] const char* name_of(Backend backend);
[[nodiscard]] Backend
backend_named(const std::string& name); // "auto", "egl-device", "egl-surfaceless", "osmesa"; throws Error

} // namespace ciel::render
