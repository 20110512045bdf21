// NASA's blunt fin dataset, if present: a shaded volume of the vortices, whole and cut open.
#include "support/golden/golden.hpp"
#include "support/meshes.hpp"
#include "unit/render/volume_scene.hpp"

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>

namespace server::render {
using namespace ciel;
namespace {

constexpr int width = 360, height = 270;
constexpr std::size_t columns = 40, rows = 32, sheets = 32, points = columns * rows * sheets;

// Reads floats of a PLOT3D file with one grid: three counts, four numbers in a solution file, then arrays. All numbers
// are big-endian.
std::vector<float> read_plot3d(const std::filesystem::path& path, std::size_t skipped, std::size_t count) {
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(4 * (3 + skipped)));
    std::vector<unsigned char> bytes(4 * count);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file) throw std::runtime_error(path.string() + " is too short");
    std::vector<float> numbers;
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
        const std::uint32_t bits = std::uint32_t{bytes[i]} << 24 | std::uint32_t{bytes[i + 1]} << 16 |
                                   std::uint32_t{bytes[i + 2]} << 8 | std::uint32_t{bytes[i + 3]};
        numbers.push_back(std::bit_cast<float>(bits));
    }
    return numbers;
}

VolumeScene blunt_fin(const std::filesystem::path& folder) {
    const std::vector<float> xyz = read_plot3d(folder / "bluntfinxyz.bin", 0, 3 * points);
    const std::vector<float> density = read_plot3d(folder / "bluntfinq.bin", 4, points);
    test::Polyhedra mesh = test::hexahedra({{columns - 1, rows - 1, sheets - 1}});
    std::map<Vec3d, double> density_at;
    for (std::size_t v = 0; v < points; ++v) {
        for (std::size_t axis = 0; axis < 3; ++axis) mesh.positions[3 * v + axis] = xyz[axis * points + v];
        density_at[mesh.position(static_cast<test::Id>(v))] = density[v];
    }
    return VolumeScene(mesh, [&](const Vec3d& p) { return density_at.at(p); });
}

TEST(GoldenVolume, TheBluntFinWholeAndCutOpen) {
    const char* data = std::getenv("CIEL_DATA");
    const std::filesystem::path folder = std::filesystem::path(data != nullptr ? data : "data") / "nasa";
    if (!std::filesystem::exists(folder / "bluntfinq.bin")) GTEST_SKIP() << "needs the blunt fin, " << folder;
    VolumeScene scene = blunt_fin(folder);
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.samples = 4;
    frame.bounds_min = {-6.4, 0, 0};
    frame.bounds_max = {11.1, 8.5, 5.5};
    frame.camera.target = {2, 3, 2};
    frame.camera.position = {-12, -14, 14};
    frame.background_top = frame.background_bottom = {0.05F, 0.06F, 0.08F};
    Volume volume = scene.volume({0, 1, 0}, 100);
    volume.scale.map = "viridis";
    volume.scale.range = {0.2F, 5};
    volume.opacity_points = {{0, 0.4}, {0.1, 0.05}, {0.2, 0.15}, {0.45, 0.6}, {1, 0.95}};
    volume.unit_length = 2;
    volume.shaded = true;
    frame.volumes = {volume};
    for (const Backend backend : available_backends()) {
        Renderer renderer(backend);
        Image image;
        frame.clip.clear();
        renderer.draw(frame, image);
        EXPECT_TRUE(test::matches_golden("blunt_fin", {width, height, image.rgb}, name_of(backend)));
        frame.clip = {{0, 1, 0, -1}, {1, 0, 0.5F, 2.5F}}; // the half-space y >= 1 and an oblique one
        renderer.draw(frame, image);
        EXPECT_TRUE(test::matches_golden("blunt_fin_cut_open", {width, height, image.rgb}, name_of(backend)));
    }
}

} // namespace
} // namespace server::render
