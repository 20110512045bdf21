// Ambient occlusion on a ball and a bowl on a floor against a wall, with lines, a transparent sheet and a volume.
#include "support/golden/golden.hpp"
#include "support/meshes.hpp"
#include "unit/render/scenes.hpp"
#include "unit/render/volume_scene.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

Shape bowl(const Vec3d& center, double radius) {
    return grid(64, 24, [&](double u, double v) {
        const double longitude = 2 * std::numbers::pi * u, latitude = -std::numbers::pi / 2 * (1 - v);
        return Vec3f{static_cast<float>(center[0] + radius * std::cos(latitude) * std::cos(longitude)),
                     static_cast<float>(center[1] + radius * std::cos(latitude) * std::sin(longitude)),
                     static_cast<float>(center[2] + radius * std::sin(latitude))};
    });
}

Shape rectangle(const Vec3d& corner, const Vec3d& along, const Vec3d& up) {
    return grid(1, 1, [&](double u, double v) {
        Vec3f p{};
        for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<float>(corner[k] + u * along[k] + v * up[k]);
        return p;
    });
}

class Room {
public:
    explicit Room(int samples) {
        frame_.width = 480;
        frame_.height = 320;
        frame_.samples = samples;
        frame_.bounds_min = {0, 0, 0};
        frame_.bounds_max = {8, 8, 4};
        frame_.background_top = frame_.background_bottom = {0.1F, 0.11F, 0.13F};
        frame_.camera = {{4, -11, 7}, {4, 4, 1.2}, {0, 0, 1}, 30};
        frame_.occlusion = {1.2, 1};
        const std::array<std::array<float, 4>, 6> colors{{{0.8F, 0.8F, 0.8F, 1},
                                                          {0.75F, 0.8F, 0.85F, 1},
                                                          {0.9F, 0.5F, 0.2F, 1},
                                                          {0.3F, 0.7F, 0.4F, 1},
                                                          {0.2F, 0.6F, 0.9F, 0.4F},
                                                          {0.9F, 0.9F, 0.3F, 1}}};
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            Primitives primitives = shapes_[i].primitives();
            primitives.scalars = {};
            primitives.color = colors[i];
            frame_.primitives.push_back(primitives);
        }
        frame_.primitives.back().lines = true;
        Volume volume = fog_.volume({1, 0, 0}, 40);
        volume.scale.map = "viridis";
        volume.scale.range = {0, 2};
        volume.opacity_points = {{0, 0.6}, {0.5, 0.2}, {1, 0}};
        volume.unit_length = 1;
        frame_.volumes = {volume};
    }
    test::Picture draw(Renderer& renderer) {
        Image image;
        renderer.draw(frame_, image);
        return {image.width, image.height, image.rgb};
    }

private:
    VolumeScene fog_{test::hexahedra({{2, 2, 2}}), [](const Vec3d& p) { return std::hypot(p[0], p[1], p[2]); }};
    std::array<Shape, 6> shapes_{rectangle({0, 0, 0}, {8, 0, 0}, {0, 8, 0}),
                                 rectangle({0, 8, 0}, {8, 0, 0}, {0, 0, 4}),
                                 sphere(1, {3.2, 5, 1}),
                                 bowl({6, 4.5, 1.2}, 1.2),
                                 rectangle({2.2, 3, 0}, {2.5, 0, 0}, {0, 0, 2.5}),
                                 Shape{{{0.5F, 1, 0.5F}, {7.5F, 7, 3.5F}}, {}, {}, {0, 1}}};
    Frame frame_;
};

TEST(GoldenOcclusion, StillAndMoving) {
    for (const int samples : {1, 4}) {
        Room room(samples);
        for (const Backend backend : available_backends()) {
            Renderer renderer(backend);
            EXPECT_TRUE(test::matches_golden(samples == 1 ? "ambient_occlusion_moving" : "ambient_occlusion",
                                             room.draw(renderer), name_of(backend)));
        }
    }
}

} // namespace
} // namespace server::render
