// VTK XML PolyData, appended raw (VTK file formats, "XML File Formats").
#pragma once

#include "wire/files/exported_surface.hpp"

#include <ostream>

namespace ciel::wire {

// VTK XML, appended raw, double positions. A failed stream is the caller's to check.
ExportedCounts write_vtp(const ExportSurface& surface, std::ostream& out);

} // namespace ciel::wire
