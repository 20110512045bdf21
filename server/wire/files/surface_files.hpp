// The formats of surfaces in files, by name.
#pragma once

#include "wire/files/exported_surface.hpp"

#include <cstdint>
#include <ostream>
#include <string>

namespace ciel::wire {

enum class SurfaceFormat { ply, stl, vtp };
// STL has floats only.
[[nodiscard]] bool has_floats(SurfaceFormat format);
[[nodiscard]] SurfaceFormat surface_format(const std::string& extension); // ".ply"; throws Error with the known ones

// Returns what was written. A failed stream is the caller's to check.
ExportedCounts write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out);

// Of the file, but for its head, which is small: for those who want to know before it is made.
[[nodiscard]] std::uint64_t body_bytes(SurfaceFormat format, const ExportSurface& surface);

} // namespace ciel::wire
