// A volume drawn while something moves uses every third or fifth slice at half resolution. Its brightness and color
// must match the still's.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

namespace server::render {
using namespace ciel;
namespace {

struct Colors {
    const char* name;
    std::vector<std::array<double, 2>> opacity_points;
    bool shaded;
};

// Limits on the differences, in 255ths. Pixels near the mesh's outline are left out, where coarse pixels mix mesh and
// background.
constexpr double most_mean = 1, most_of_pixels = 6, share_of_pixels = 0.995;

void expect_alike(const Image& moving, const Image& still, const std::string& what) {
    const auto at = [](const Image& image, int x, int y, std::size_t k) {
        return static_cast<int>(image.rgb[3 * static_cast<std::size_t>(y * image.width + x) + k]);
    };
    const auto is_on_outline = [&](int x, int y) { // within two pixels there is background and something else
        bool any = false, all = true;
        for (int v = std::max(0, y - 2); v <= std::min(still.height - 1, y + 2); ++v)
            for (int u = std::max(0, x - 2); u <= std::min(still.width - 1, x + 2); ++u) {
                const bool is_empty = at(still, u, v, 2) <= 20; // the pixel shows the background
                any = any || is_empty;
                all = all && is_empty;
            }
        return any && !all;
    };
    double sum[3] = {};
    int pixels = 0, off = 0, seen = 0;
    for (int y = 0; y < still.height; ++y)
        for (int x = 0; x < still.width; ++x) {
            if (is_on_outline(x, y)) continue;
            ++pixels;
            int worst = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const int difference = at(moving, x, y, k) - at(still, x, y, k);
                sum[k] += difference;
                worst = std::max(worst, std::abs(difference));
            }
            off += worst > most_of_pixels ? 1 : 0;
            seen += at(still, x, y, 2) > 20 ? 1 : 0;
        }
    EXPECT_GT(seen, pixels / 10) << what;
    EXPECT_LE(off, (1 - share_of_pixels) * pixels) << what;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(std::abs(sum[k] / seen), most_mean) << what << ", channel " << k;
}

TEST(MovingVolume, HasTheColorsOfItsStill) {
    VolumeScene scene(test::hexahedra({{6, 6, 6}, 0, 1, 1.0 / 6}),
                      [](const Vec3d& p) { return p[0] + 0.5 * p[1] + 0.3 * std::sin(3 * p[2]); });
    for (const Colors& colors :
         {Colors{"thin", {{0, 0.1}, {1, 0.3}}, false}, Colors{"dense", {{0, 0.3}, {1, 0.8}}, false},
          Colors{"shaded", {{0, 0.2}, {1, 0.6}}, true}})
        for (const View& view : views) {
            Frame frame = frame_of(view);
            frame.background_top = frame.background_bottom = {0, 0, 16.0F / 255};
            Volume volume = scene.volume(nearest_axis(view.from), 105);
            volume.scale.points = {{0, {40, 90, 255}}, {0.5, {230, 230, 230}}, {1, {250, 140, 60}}};
            volume.scale.range = {-0.3F, 2};
            volume.opacity_points = colors.opacity_points;
            volume.unit_length = 0.3;
            volume.shaded = colors.shaded;
            frame.samples = 4;
            frame.volumes = {volume};
            Image still, moving;
            renderer().draw(frame, still);
            frame.samples = 1;
            for (const std::size_t stride : {3U, 5U}) {
                frame.volumes[0].stride = stride;
                frame.volumes[0].coarseness = 2;
                renderer().draw(frame, moving);
                expect_alike(moving, still,
                             std::string(colors.name) + ", " + view.name + ", stride " + std::to_string(stride));
            }
        }
}

// Smallest and largest value of channel k among the 3 x 3 pixels around (x, y).
std::array<int, 2> ends_around(const Image& image, int x, int y, std::size_t k) {
    std::array<int, 2> ends{255, 0};
    for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u) {
            const int one = image.rgb[3 * static_cast<std::size_t>(v * image.width + u) + k];
            ends = {std::min(ends[0], one), std::max(ends[1], one)};
        }
    return ends;
}

// At half resolution one ray serves 2 x 2 pixels. A ray that hit the ball has no fog from behind it for neighbors
// beside the ball. A ray that missed the ball has too much fog for pixels on it.
TEST(MovingVolume, HasNoFringeAtTheOutlineOfASurface) {
    VolumeScene fog(test::hexahedra({{6, 6, 6}, 0, 1, 1.0 / 6}), [](const Vec3d&) { return 1; });
    const Shape ball = sphere(0.3, {0.5, 0.5, 0.5}, 96);
    for (const View& view : {views[1], views[2], views[4], views[5]}) {
        Frame frame = frame_of(view);
        frame.background_top = frame.background_bottom = {1, 1, 1};
        frame.primitives.push_back(ball.primitives());
        frame.primitives[0].color = {0.9F, 0.9F, 0.2F, 1};
        Volume volume = fog.volume(nearest_axis(view.from), 45);
        volume.scale.points = {{0, {20, 40, 120}}, {1, {20, 40, 120}}};
        volume.opacity_points = {{0, 0.9}, {1, 0.9}};
        volume.unit_length = 0.5;
        frame.volumes = {volume};
        frame.samples = 1;
        Image sharp, moving;
        renderer().draw(frame, sharp);
        frame.volumes[0].stride = 3;
        frame.volumes[0].coarseness = 2;
        renderer().draw(frame, moving);
        int off = 0;
        for (int y = 7 * side / 20; y < 13 * side / 20; ++y) // leaves out the volume's own outline
            for (int x = 7 * side / 20; x < 13 * side / 20; ++x)
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto [low, high] = ends_around(sharp, x, y, k);
                    const int one = moving.rgb[3 * static_cast<std::size_t>(y * side + x) + k];
                    off += one < low - 3 || one > high + 3 ? 1 : 0;
                }
        EXPECT_EQ(off, 0) << view;
    }
}

} // namespace
} // namespace server::render
