// The file formats of surfaces: PLY, STL and VTP.
#pragma once

#include "wire/files/exported_surface.hpp"

#include <cstdint>
#include <ostream>
#include <string>

namespace server::wire {

enum class SurfaceFormat { ply, stl, vtp };
// Returns whether the format stores positions as floats, as STL does.
[[nodiscard]] bool has_floats(SurfaceFormat format);
// Returns the format of a file extension such as ".ply". Throws Error, which lists the known extensions.
[[nodiscard]] SurfaceFormat surface_format(const std::string& extension);

// Writes a surface and returns the numbers of written polygons and vertices. The caller checks the stream for failure.
ExportedCounts write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out);

// Returns the size of the file in bytes, without its header. Lets callers refuse an export before it is written.
[[nodiscard]] std::uint64_t body_bytes(SurfaceFormat format, const ExportSurface& surface);

} // namespace server::wire
