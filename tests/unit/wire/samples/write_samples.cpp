// Writes pictures, and one surface in every format, for read_by_others.py.
#include "../pictures.hpp"
#include "wire/files/surface_files.hpp"
#include "wire/pictures/png.hpp"
#include "wire/pictures/png_stream.hpp"

#include <filesystem>
#include <fstream>

namespace {

using namespace ciel;
using namespace server;

// A prism far from the origin: two hexagons, six squares, and polygons without area, which the files must not contain.
Surface prism() {
    Surface surface;
    for (const float z : {0.0F, 1.0F})
        for (int i = 0; i < 6; ++i) {
            const double angle = i * 1.0471975511965976;
            surface.positions.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), z});
            surface.normals.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
        }
    surface.positions.push_back(surface.positions[0]); // a second vertex at the same position
    surface.normals.push_back({0, 0, 1});
    const auto add = [&](std::initializer_list<Index> polygon) {
        surface.polygon_vertex.insert(surface.polygon_vertex.end(), polygon);
        surface.polygon_offset.push_back(static_cast<Index>(surface.polygon_vertex.size()));
        surface.polygon_cell.push_back(0);
    };
    add({5, 4, 3, 2, 1, 0});
    add({0, 12, 0});
    add({6, 7, 8, 9, 10, 11});
    for (Index i = 0; i < 6; ++i) add({i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
    add({0, 6, 12});
    surface.points.resize(surface.positions.size());
    return surface;
}

void write(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

} // namespace

int main(int, char** arguments) {
    const std::filesystem::path folder = arguments[1];
    for (const wire::Picture& picture : wire::pictures()) {
        write(folder / (picture.name + ".rgb"), picture.rgb);
        std::vector<std::uint8_t> still, moving;
        wire::encode_png(picture.width, picture.height, picture.rgb, still);
        wire::PngStream().encode(picture.width, picture.height, picture.rgb, moving);
        write(folder / (picture.name + ".still.png"), still);
        write(folder / (picture.name + ".interactive.png"), moving);
    }
    const Surface surface = prism();
    wire::ExportSurface sample{surface, {500000.0, 4000000.0, 0.25}, {{"a <b> & \"c\"", {}}}, false};
    for (const Vec3f& p : surface.positions) sample.values[0].values.push_back(p[0] + 10 * p[2]);
    for (const bool triangles : {false, true}) {
        sample.triangles = triangles;
        for (const char* extension : {".ply", ".stl", ".vtp"}) {
            std::ofstream out(folder / ((triangles ? "triangles" : "polygons") + std::string(extension)),
                              std::ios::binary);
            wire::write_surface(wire::surface_format(extension), sample, out);
        }
    }
}
