// VTK XML PolyData, appended raw (VTK file formats, "XML File Formats").
#pragma once

#include "wire/files/exported_surface.hpp"

#include <ostream>

namespace server::wire {

// Writes a VTP file with positions as doubles. The caller checks the stream for failure.
ExportedCounts write_vtp(const ExportSurface& surface, std::ostream& out);

} // namespace server::wire
