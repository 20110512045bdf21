// PLY, binary little-endian (G. Turk, The PLY Polygon File Format, 1994).
#pragma once

#include "wire/files/exported_surface.hpp"

#include <ostream>

namespace server::wire {

// Writes a PLY file with positions as doubles. The caller checks the stream for failure.
ExportedCounts write_ply(const ExportSurface& surface, std::ostream& out);

} // namespace server::wire
