// A dense volume that is drawn while something moves has the colors of its still, although it has fewer slabs and is
// less sharp.
#include "geometry/volume_cut.hpp"
#include "support/meshes.hpp"
#include "unit/render/volume_compare.hpp"

#include <cmath>

namespace server::render {
using namespace ciel;
namespace {

constexpr int block = 8;          // Side of a block in pixels. The mean color of a block does not depend on sharpness.
constexpr std::size_t cells = 28; // cells along an edge of the cube
constexpr std::size_t slices = 200;

double wake(const Vec3d& p) { return std::sin(15 * p[0] + 4 * std::sin(6 * p[2])) * std::cos(13 * p[1] + 5 * p[2]); }

Volume dense_wake(VolumeScene& scene, const Vec3d& normal) {
    Volume volume = scene.volume(normal, slices);
    volume.scale.points = {{0, {20, 60, 200}}, {0.5, {240, 240, 240}}, {1, {200, 50, 30}}};
    volume.scale.range = {-1, 1};
    volume.opacity_points = {{0, 0.95}, {0.35, 0.3}, {0.45, 0}, {0.55, 0}, {0.65, 0.3}, {1, 0.95}};
    volume.unit_length = 0.1;
    return volume;
}

std::array<double, 3> mean_of(const Image& image, int left, int top) {
    std::array<double, 3> sum{};
    for (int y = top; y < top + block; ++y)
        for (int x = left; x < left + block; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += image.rgb[3 * static_cast<std::size_t>(y * image.width + x) + k];
    for (double& one : sum) one /= block * block;
    return sum;
}

// False for blocks near the volume's outline, where the still is sharper.
bool is_full(const Image& image, int left, int top) {
    for (int y = std::max(0, top - 2); y < std::min(image.height, top + block + 2); ++y)
        for (int x = std::max(0, left - 2); x < std::min(image.width, left + block + 2); ++x)
            if (image.rgb[3 * static_cast<std::size_t>(y * image.width + x)] == 0) return false;
    return true;
}

// Mean and largest difference of the blocks' mean colors, in 255ths.
std::array<double, 2> difference(const Image& still, const Image& moving) {
    double sum = 0, most = 0;
    int seen = 0;
    for (int y = 0; y + block <= still.height; y += block)
        for (int x = 0; x + block <= still.width; x += block) {
            if (!is_full(still, x, y)) continue;
            const auto one = mean_of(still, x, y), other = mean_of(moving, x, y);
            ++seen;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += std::abs(one[k] - other[k]) / 3;
                most = std::max(most, std::abs(one[k] - other[k]));
            }
        }
    EXPECT_GT(seen, 50);
    return {sum / seen, most};
}

TEST(DenseVolume, HasTheColorsOfItsStillWhileItMoves) {
    VolumeScene scene(test::hexahedra({{cells, cells, cells}, 0, 1, 1.0 / cells}), wake);
    const std::size_t vertices = (cells + 1) * (cells + 1) * (cells + 1);
    for (const View& view : {views[2], views[4]}) {
        Frame frame = frame_of(view);
        const Volume volume = dense_wake(scene, nearest_axis(view.from));
        frame.volumes = {volume};
        frame.samples = 4;
        Image still, moving;
        renderer().draw(frame, still);
        frame.samples = 1;
        frame.volumes[0].stride = geometry::moving_stride(
            slices, vertices, geometry::largest_loss(volume.opacity_points, volume.unit_length, 1));
        frame.volumes[0].coarseness = 2;
        renderer().draw(frame, moving);
        const auto [mean, most] = difference(still, moving);
        EXPECT_LT(mean, 1) << view;
        EXPECT_LT(most, 5) << view;
    }
}

} // namespace
} // namespace server::render
