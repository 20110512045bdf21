// Two surfaces of 50 % opacity, a volume around them and an opaque slice through both, from six sides in one picture.
#include "support/golden/golden.hpp"
#include "support/meshes.hpp"
#include "unit/render/scenes.hpp"
#include "unit/render/volume_scene.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr int width = 240, height = 180, columns = 3;
constexpr double side = 8, middle = side / 2;

struct Look {
    Vec3d from, up;
};

constexpr std::array<Look, 6> looks{{{{1, 0.3, 0.2}, {0, 0, 1}},
                                     {{-1, 0.3, 0.2}, {0, 0, 1}},
                                     {{0.3, 1, 0.2}, {0, 0, 1}},
                                     {{0.3, -1, 0.2}, {0, 0, 1}},
                                     {{0.2, 0.3, 1}, {0, 1, 0}},
                                     {{0.2, 0.3, -1}, {0, 1, 0}}}};

double from_the_middle(const Vec3d& p) { return std::hypot(p[0] - middle, p[1] - middle, p[2] - middle); }

class Layers {
public:
    Layers() {
        frame_.width = width;
        frame_.height = height;
        frame_.samples = 4;
        frame_.bounds_min = {0, 0, 0};
        frame_.bounds_max = {side, side, side};
        frame_.background_top = frame_.background_bottom = {0.1F, 0.11F, 0.13F};
        const std::array<std::array<float, 4>, 3> colors{
            {{0.9F, 0.5F, 0.2F, 0.5F}, {0.2F, 0.6F, 0.9F, 0.5F}, {0.8F, 0.8F, 0.8F, 1}}};
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            Primitives primitives = shapes_[i].primitives();
            primitives.scalars = {};
            primitives.color = colors[i];
            frame_.primitives.push_back(primitives);
        }
    }

    test::Picture draw(Renderer& renderer) {
        test::Picture all{columns * width, 2 * height, {}};
        all.rgb.resize(std::size_t{3} * columns * width * 2 * height);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            look(looks[i]);
            Image image;
            renderer.draw(frame_, image);
            for (std::size_t row = 0; row < height; ++row)
                std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * row * width), 3 * width,
                            all.rgb.begin() +
                                static_cast<std::ptrdiff_t>(
                                    3 * ((i / columns * height + row) * columns * width + i % columns * width)));
        }
        return all;
    }

private:
    void look(const Look& from) {
        frame_.camera.target = {middle, middle, middle};
        for (std::size_t axis = 0; axis < 3; ++axis) frame_.camera.position[axis] = middle + 20 * from.from[axis];
        frame_.camera.up = from.up;
        std::size_t steepest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (std::abs(from.from[axis]) > std::abs(from.from[steepest])) steepest = axis;
        Vec3d normal{};
        normal[steepest] = 1;
        Volume volume = fog_.volume(normal, 60);
        volume.scale.map = "viridis";
        volume.scale.range = {0, 5};
        volume.opacity_points = {{0, 0.4}, {0.9, 0.1}, {1, 0}};
        volume.unit_length = 2;
        frame_.volumes = {volume};
    }

    VolumeScene fog_{test::hexahedra({{8, 8, 8}}), from_the_middle};
    std::array<Shape, 3> shapes_{
        sphere(3, {middle, middle, middle}), sphere(1.6, {middle + 1, middle, middle}),
        grid(1, 1, [](double u, double v) {
            return Vec3f{static_cast<float>(side * u), static_cast<float>(side * v), static_cast<float>(middle)};
        })};
    Frame frame_;
};

TEST(GoldenLayers, LookRightFromSixSides) {
    Layers layers;
    for (const Backend backend : available_backends()) {
        Renderer renderer(backend);
        EXPECT_TRUE(test::matches_golden("layers_from_six_sides", layers.draw(renderer), name_of(backend)));
    }
}

} // namespace
} // namespace server::render
