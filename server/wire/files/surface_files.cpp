#include "wire/files/surface_files.hpp"

#include "ciel/types.hpp"
#include "wire/files/export_ply.hpp"
#include "wire/files/export_stl.hpp"
#include "wire/files/export_vtp.hpp"

namespace server::wire {

bool has_floats(SurfaceFormat format) { return format == SurfaceFormat::stl; }

SurfaceFormat surface_format(const std::string& extension) {
    if (extension == ".ply") return SurfaceFormat::ply;
    if (extension == ".stl") return SurfaceFormat::stl;
    if (extension == ".vtp") return SurfaceFormat::vtp;
    throw ciel::Error("'" + extension + "' is not a surface format; use .ply, .stl or .vtp");
}

ExportedCounts write_surface(SurfaceFormat format, const ExportSurface& surface, std::ostream& out) {
    switch (format) {
    case SurfaceFormat::ply:
        return write_ply(surface, out);
    case SurfaceFormat::stl:
        return write_stl(surface, out);
    case SurfaceFormat::vtp:
        return write_vtp(surface, out);
    }
    return {};
}

std::uint64_t body_bytes(SurfaceFormat format, const ExportSurface& surface) {
    const bool is_stl = format == SurfaceFormat::stl;
    const ExportedPolygons polygons = exported_polygons(surface.surface, is_stl || surface.triangles);
    const std::uint64_t faces = polygons.counts().polygons, vertices = polygons.vertices.size();
    std::uint64_t per_vertex = 24 + (surface.surface.normals.empty() ? 0 : 12);
    for (const NamedValues& values : surface.values) per_vertex += values.value_bytes();
    const std::uint64_t indices = faces + polygons.corner.size(); // a size or offset per face, and its corners
    switch (format) {
    case SurfaceFormat::ply:
        return vertices * per_vertex + 4 * indices;
    case SurfaceFormat::stl:
        return 50 * faces;
    case SurfaceFormat::vtp:
        return vertices * per_vertex + 8 * indices;
    }
    return 0;
}

} // namespace server::wire
