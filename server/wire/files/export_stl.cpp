#include "wire/files/export_stl.hpp"

#include "wire/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace server::wire {
namespace {

ciel::Vec3f facet_normal(const std::array<ciel::Vec3f, 3>& corners) {
    ciel::Vec3d a{}, b{}, n{};
    for (std::size_t k = 0; k < 3; ++k) {
        a[k] = double{corners[1][k]} - corners[0][k];
        b[k] = double{corners[2][k]} - corners[0][k];
    }
    for (std::size_t k = 0; k < 3; ++k) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length == 0) return {};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
}

} // namespace

ExportedCounts write_stl(const ExportSurface& surface, std::ostream& out) {
    const ExportedPolygons triangles = exported_polygons(surface.surface, true);
    std::array<char, 80> title{};
    std::string text = "CIEL surface"; // must not begin with "solid", because "solid" marks ASCII files
    if (surface.file_origin != ciel::Vec3d{}) text += ", origin " + origin_text(surface.file_origin);
    std::copy_n(text.begin(), std::min(text.size(), title.size()), title.begin());
    out.write(title.data(), title.size());
    write_raw(out, static_cast<std::uint32_t>(triangles.offset.size() - 1));
    for (std::size_t c = 0; c + 3 <= triangles.corner.size(); c += 3) {
        std::array<ciel::Vec3f, 3> local{};
        std::array<ciel::Vec3f, 3> world{};
        for (std::size_t i = 0; i < 3; ++i) {
            const ciel::Index vertex = triangles.vertices[triangles.corner[c + i]];
            local[i] = surface.surface.positions[vertex];
            const ciel::Vec3d place = surface.place(vertex);
            for (std::size_t k = 0; k < 3; ++k) world[i][k] = static_cast<float>(place[k]);
        }
        write_raw(out, facet_normal(local));
        write_raw(out, world);
        write_raw(out, std::uint16_t{0});
    }
    return triangles.counts();
}

} // namespace server::wire
