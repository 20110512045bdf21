// A surface as a file's bytes: one format per .cpp (export_ply, export_stl, export_vtp).
#pragma once

#include "ciel/extract.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace ciel::wire {

struct NamedValues {
    std::string name;
    std::vector<float> values; // one per surface vertex
};

struct ExportSurface {
    const Surface& surface;
    Vec3d origin{}; // added in double, so files far from the origin keep their digits where the format can
    std::vector<NamedValues> values;
    bool triangles = false; // else polygons as they are (STL always has triangles)
};

enum class SurfaceFormat { ply, stl, vtp };
[[nodiscard]] SurfaceFormat surface_format(const std::string& extension); // ".ply"; throws Error with the known ones

void write_ply(const ExportSurface& surface, std::ostream& out); // binary little-endian, double positions
void write_stl(const ExportSurface& surface, std::ostream& out); // binary
void write_vtp(const ExportSurface& surface, std::ostream& out); // VTK XML, appended raw
void write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out);

} // namespace ciel::wire
