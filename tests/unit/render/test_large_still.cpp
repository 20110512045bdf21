// A still of 4096 x 4096 with a volume, surfaces and text looks like a small one, with more pixels.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"
#include "wire/pictures/png.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr int small = 1024, factor = 4, margin = 160;

Image drawn(Renderer& renderer, Frame& frame, int side) {
    frame.width = frame.height = side;
    Image image;
    renderer.draw(frame, image);
    return image;
}

// Differences of each pixel of the small picture from the mean of its block in the large one. Leaves the margin out,
// because text is hinted to whole pixels of each picture.
struct Difference {
    double mean = 0;
    int far_off = 0; // channels that differ by more than 40 of 255, which a shifted edge does not reach
};

Difference compare(const Image& large, const Image& little) {
    Difference difference;
    for (int y = margin; y < small - margin; ++y)
        for (int x = 3 * margin; x < 3 * (small - margin); ++x) {
            int sum = 0;
            for (int dy = 0; dy < factor; ++dy)
                for (int dx = 0; dx < factor; ++dx) {
                    const int column = x / 3 * factor + dx;
                    sum +=
                        large.rgb[static_cast<std::size_t>(3 * (y * factor + dy) * large.width + 3 * column + x % 3)];
                }
            const double off = std::abs(static_cast<double>(sum) / (factor * factor) -
                                        little.rgb[static_cast<std::size_t>(3 * y * small + x)]);
            difference.mean += off / (3.0 * (small - 2 * margin) * (small - 2 * margin));
            if (off > 40) ++difference.far_off;
        }
    return difference;
}

void keep(const Image& image, const char* name) {
    const auto folder = std::filesystem::path(CIEL_BINARY_DIR) / "pictures";
    std::filesystem::create_directories(folder);
    std::vector<std::uint8_t> png;
    wire::encode_png(image.width, image.height, image.rgb, png);
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
}

double resident_gigabytes() {
    std::ifstream status("/proc/self/statm");
    double all = 0, resident = 0;
    status >> all >> resident;
    return resident * 4096 / 1e9;
}

TEST(LargeStillTest, OfAVolumeTransparentSurfacesAndWriting) {
    Renderer renderer(Backend::automatic);
    VolumeScene scene(test::hexahedra({{3, 3, 3}, 0, 1, 1.0 / 3}), [](const Vec3d& p) { return p[0]; });
    const Shape plane = square(0.5), ball = sphere(0.7), inner = sphere(0.4, {0.3, 0, 0.2});
    Frame frame = front_view();
    frame.camera.position = {1.5, -5, 1};
    frame.samples = 4;
    frame.primitives = {plane.primitives(), ball.primitives(), inner.primitives()};
    frame.primitives[1].color = {0.9F, 0.4F, 0.2F, 0.4F};
    frame.primitives[2].color = {0.2F, 0.5F, 0.9F, 0.6F};
    frame.volumes = {scene.volume({0, 1, 0}, 31)};
    frame.annotations.title = "A large still";
    frame.annotations.legends.push_back({"x", "m", {}});
    frame.annotations.triad = true;
    const Image little = drawn(renderer, frame, small);
    const Image large = drawn(renderer, frame, small * factor);
    ASSERT_EQ(large.rgb.size(), std::size_t{3} * small * small * factor * factor);
    const Difference same = compare(large, little);
    EXPECT_LT(same.mean, 1.5);
    EXPECT_LT(same.far_off, small * small / 100) << "at outlines";
    if (HasFailure()) {
        keep(little, "still_of_1024.png");
        keep(large, "still_of_4096.png");
    }
    const double held = resident_gigabytes();
    frame.primitives[1].color[3] = 0.7F;
    EXPECT_GT(compare(large, drawn(renderer, frame, small)).mean, same.mean + 1) << "a test that sees nothing";
    // Only llvmpipe allocates textures in this process.
    if (renderer.gl_renderer().find("llvmpipe") == std::string::npos) return;
    EXPECT_LT(resident_gigabytes(), held - 0.5) << "what the large one took is given back";
}

// At 3840 x 2160. The ball has an opacity of 50 %, so pixels on its outline lie between its color and the background's.
TEST(LargeStillTest, OfALargeScreenHasSmoothTransparentOutlines) {
    Renderer renderer(Backend::automatic);
    const Shape ball = sphere(1.2);
    Frame frame = front_view(3840, 2160);
    frame.samples = 4;
    frame.background_top = frame.background_bottom = {0, 0, 0};
    frame.primitives = {ball.primitives()};
    frame.primitives[0].lit = false;
    frame.primitives[0].color = {1, 1, 1, 0.5F};
    Image image;
    renderer.draw(frame, image);
    int between = 0, rows = 0;
    for (int y = 400; y < frame.height - 400; ++y) {
        int own = 0;
        for (int x = 0; x < frame.width / 2; ++x) {
            const int grey = image.rgb[3 * (static_cast<std::size_t>(y) * frame.width + x)];
            own += grey > 10 && grey < 117 ? 1 : 0;
        }
        ++rows;
        between += own > 0 ? 1 : 0;
    }
    EXPECT_GT(between, rows / 2);
}

} // namespace
} // namespace server::render
