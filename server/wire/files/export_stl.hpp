// STL, binary (3D Systems, 1989): float32 triangles without connectivity.
#pragma once

#include "wire/files/exported_surface.hpp"

#include <ostream>

namespace server::wire {

// Writes an STL file with positions as floats and without values. The caller checks the stream for failure.
ExportedCounts write_stl(const ExportSurface& surface, std::ostream& out);

} // namespace server::wire
