// Outlines of opaque surfaces in fog, in a still: as smooth as those in the open, where each sample is by itself. Rays
// through every part of a pixel say how bright it is.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

namespace ciel::render {
namespace {

using test::Box;

constexpr double fog_opacity = 0.9;
constexpr int parts = 8; // of a pixel along a side

Ray ray_of_part(const Frame& frame, int x, int y, int part) {
    const int column = part % parts, row = part / parts;
    return ray_of(frame, x + (column + 0.5) / parts, y + (row + 0.5) / parts);
}

struct Ball {
    Vec3d center;
    double radius;

    // Where a ray meets it; infinite where it does not.
    [[nodiscard]] double hit(const Ray& ray) const {
        const Vec3d to = plus(center, ray[0], -1);
        const double along = to[0] * ray[1][0] + to[1] * ray[1][1] + to[2] * ray[1][2];
        const double apart = to[0] * to[0] + to[1] * to[1] + to[2] * to[2] - along * along;
        return apart < radius * radius ? along - std::sqrt(radius * radius - apart)
                                       : std::numeric_limits<double>::infinity();
    }
};

class OutlineInFog : public testing::Test {
protected:
    void SetUp() override {
        frame.samples = 4;
        frame.bounds_min = {-1, -0.2, -1}; // of all that is drawn
        Volume volume = fog.volume({0, 1, 0}, 100);
        volume.scale.points = {{0, {255, 255, 255}}, {1, {255, 255, 255}}};
        volume.scale.range = {0, 1};
        volume.opacity_points = {{0, fog_opacity}};
        frame.volumes = {volume};
        add(sphere(ball.radius, ball.center, 256));
    }
    Mesh& add(const Shape& shape) {
        shapes.push_back(shape);
        Mesh mesh = shapes.back().mesh();
        mesh.scalars = {};
        mesh.color = {0, 0, 0, 1};
        mesh.lit = false;
        frame.meshes.push_back(mesh);
        return frame.meshes.back();
    }
    [[nodiscard]] double light(const Ray& ray) const {
        auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
        to = std::min({to, ball.hit(ray), (wall - ray[0][1]) / ray[1][1]});
        return 1 - std::pow(1 - fog_opacity, std::max(0.0, to - from));
    }
    // Mean difference of the pixels that the ball's outline runs through, of the step that it is; `dimmed`: the share
    // of the light that comes through what else there is.
    [[nodiscard]] double roughness(double dimmed = 1) {
        Image image;
        renderer().draw(frame, image);
        double sum = 0;
        int pixels = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                double mean = 0, least = 1, most = 0;
                int on_ball = 0;
                for (int i = 0; i < parts * parts; ++i) {
                    const Ray ray = ray_of_part(frame, x, y, i);
                    const double here = light(ray);
                    on_ball += std::isfinite(ball.hit(ray)) ? 1 : 0;
                    mean += here / (parts * parts);
                    least = std::min(least, here);
                    most = std::max(most, here);
                }
                if (on_ball == 0 || on_ball == parts * parts) continue;
                const double seen = image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)] / 255.0;
                sum += std::abs(seen - dimmed * mean) / (most - least);
                ++pixels;
            }
        EXPECT_GT(pixels, 100);
        return sum / pixels;
    }

    VolumeScene fog{test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; }};
    Ball ball{{0.5, 0.5, 0.5}, 0.3};
    double wall = std::numeric_limits<double>::infinity(); // its place
    std::vector<Shape> shapes = [] {
        std::vector<Shape> kept;
        kept.reserve(4);
        return kept;
    }();
    Frame frame = frame_of({"", {0.2, -1, 0.15}, 30});
};

constexpr double smooth = 0.12; // four samples are off by so much of a step, one by a quarter

TEST_F(OutlineInFog, IsSmooth) { EXPECT_LT(roughness(), smooth); }

TEST_F(OutlineInFog, IsSmoothInAParallelView) {
    frame = frame_of({"", {0.2, -1, 0.15}, 0});
    SetUp();
    EXPECT_LT(roughness(), smooth);
}

TEST_F(OutlineInFog, IsSmoothInFrontOfAWall) {
    wall = 0.9;
    add(square(wall));
    EXPECT_LT(roughness(), smooth);
}

// Surfaces lie back for the lines on them: far behind the ball's outline where it is steep.
TEST_F(OutlineInFog, IsSmoothWithLinesAround) {
    Shape line;
    line.positions = {{0, 0, 0}, {0, 0, 1}};
    line.indices = {0, 1};
    add(line).lines = true;
    frame.meshes.back().line_width = 8;
    EXPECT_LT(roughness(), smooth);
}

// One that is opaque within a pixel or two.
TEST(OutlineOfAVolume, IsSmooth) {
    VolumeScene rock(test::hexahedra(Box{{2, 2, 2}, 0, 1, 0.5}), [](const Vec3d&) { return 1.0; });
    for (const View& view : {View{"perspective", {0.3, -1, 0.4}, 30}, View{"parallel", {0.3, -1, 0.4}, 0}})
        for (const bool among_layers : {false, true}) {
            Frame frame = frame_of(view);
            frame.samples = 4;
            Volume volume = rock.volume({0, 1, 0}, 60);
            volume.scale.points = {{0, {255, 255, 255}}, {1, {255, 255, 255}}};
            volume.scale.range = {0, 1};
            volume.opacity_points = {{0, 1}};
            volume.unit_length = 0.002;
            frame.volumes = {volume};
            const Shape behind = square(0.99); // in the dark
            Mesh sheet = behind.mesh();
            sheet.scalars = {};
            sheet.color = {0, 0, 0, 0.5F};
            if (among_layers) frame.meshes.push_back(sheet);
            const auto mean = [&](int x, int y) {
                double sum = 0;
                for (int i = 0; i < parts * parts; ++i) {
                    const auto [from, to] = inside_box(ray_of_part(frame, x, y, i), {0, 0, 0}, {1, 1, 1});
                    if (from < to) sum += 1.0 / (parts * parts);
                }
                return sum;
            };
            Image image;
            renderer().draw(frame, image);
            double off = 0;
            int pixels = 0;
            for (int y = 0; y < frame.height; ++y)
                for (int x = 0; x < frame.width; ++x) {
                    const double wanted = mean(x, y);
                    if (wanted == 0 || wanted == 1) continue;
                    off += std::abs(image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)] / 255.0 - wanted);
                    ++pixels;
                }
            EXPECT_GT(pixels, 100);
            EXPECT_LT(off / pixels, smooth) << view.name << (among_layers ? ", among layers" : "");
        }
}

// In front of all of it, so that its picture is made of layers.
TEST_F(OutlineInFog, IsSmoothBehindATransparentSheet) {
    add(square(-0.1)).color[3] = 0.4F;
    EXPECT_LT(roughness(0.6), smooth);
}

} // namespace
} // namespace ciel::render
