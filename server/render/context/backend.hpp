// The libraries and platforms that can provide OpenGL.
#pragma once

#include <string>

namespace server::render {

// Back ends, in the order in which `automatic` tries them. egl_device tries hardware devices before software devices.
enum class Backend { automatic, egl_device, egl_surfaceless, osmesa };

[[nodiscard]] const char* name_of(Backend backend);
// Accepts "auto", "egl-device", "egl-surfaceless" and "osmesa". Throws Error for any other name.
[[nodiscard]] Backend backend_named(const std::string& name);

} // namespace server::render
