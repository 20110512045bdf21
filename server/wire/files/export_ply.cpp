#include "wire/files/export_ply.hpp"

#include "wire/bytes.hpp"

#include <algorithm>

namespace server::wire {
namespace {

// PLY property names must not contain white space.
std::string property_name(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == 0x7f; }, '_');
    return name;
}

void write_ply_header(const ExportSurface& surface, const ExportedPolygons& polygons, std::ostream& out) {
    out << "ply\nformat binary_little_endian 1.0\ncomment CIEL\n";
    if (surface.file_origin != ciel::Vec3d{}) out << "comment origin " << origin_text(surface.file_origin) << '\n';
    out << "element vertex " << polygons.vertices.size() << '\n';
    for (const char axis : {'x', 'y', 'z'}) out << "property double " << axis << '\n';
    if (!surface.surface.normals.empty())
        for (const char axis : {'x', 'y', 'z'}) out << "property float n" << axis << '\n';
    for (const NamedValues& values : surface.values)
        out << (values.doubles ? "property double " : "property float ") << property_name(values.name) << '\n';
    out << "element face " << polygons.offset.size() - 1 << '\n';
    out << "property list int int vertex_indices\nend_header\n";
}

} // namespace

ExportedCounts write_ply(const ExportSurface& surface, std::ostream& out) {
    const ExportedPolygons polygons = exported_polygons(surface.surface, surface.triangles);
    write_ply_header(surface, polygons, out);
    for (const ciel::Index vertex : polygons.vertices) {
        write_raw(out, surface.place(vertex));
        if (!surface.surface.normals.empty()) write_raw(out, surface.surface.normals[vertex]);
        for (const NamedValues& values : surface.values) write_value(out, values, vertex);
    }
    for (std::size_t i = 0; i + 1 < polygons.offset.size(); ++i) {
        const ciel::Index begin = polygons.offset[i];
        const ciel::Index end = polygons.offset[i + 1];
        write_raw(out, static_cast<std::int32_t>(end - begin));
        for (ciel::Index c = begin; c < end; ++c) write_raw(out, static_cast<std::int32_t>(polygons.corner[c]));
    }
    return polygons.counts();
}

} // namespace server::wire
