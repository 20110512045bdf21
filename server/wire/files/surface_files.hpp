// The formats of surfaces in files, by name.
#pragma once

#include "wire/files/exported_surface.hpp"

#include <cstdint>
#include <ostream>
#include <string>

namespace ciel::wire {

enum class SurfaceFormat { ply, stl, vtp };
// Whether the format stores positions as floats, as STL does.
[[nodiscard]] bool has_floats(SurfaceFormat format);
[[nodiscard]] SurfaceFormat surface_format(const std::string& extension); // ".ply"; throws Error with the known ones

// Returns the numbers written. The caller checks the stream for failure.
ExportedCounts write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out);

// Size of the file in bytes, without the header. Lets callers refuse an export before it is written.
[[nodiscard]] std::uint64_t body_bytes(SurfaceFormat format, const ExportSurface& surface);

} // namespace ciel::wire
