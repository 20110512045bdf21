// Two volumes in one cube around a ball, from six sides in one picture. Each is dense where the other is thin. Their
// order must not matter.
#include "support/golden/golden.hpp"
#include "support/meshes.hpp"
#include "unit/render/scenes.hpp"
#include "unit/render/volume_scene.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr std::size_t width = 240, height = 180, columns = 3, rows = 2;
constexpr double edge = 8, middle = edge / 2;

struct Look {
    Vec3d from, up, normal;
};

constexpr std::array<Look, columns * rows> looks{{{{1, 0.3, 0.2}, {0, 0, 1}, {1, 0, 0}},
                                                  {{-1, 0.3, 0.2}, {0, 0, 1}, {1, 0, 0}},
                                                  {{0.3, 1, 0.2}, {0, 0, 1}, {0, 1, 0}},
                                                  {{0.3, -1, 0.2}, {0, 0, 1}, {0, 1, 0}},
                                                  {{0.2, 0.3, 1}, {0, 1, 0}, {0, 0, 1}},
                                                  {{0.2, 0.3, -1}, {0, 1, 0}, {0, 0, 1}}}};

double distance(const Vec3d& p, const Vec3d& from) {
    return std::hypot(p[0] - from[0], p[1] - from[1], p[2] - from[2]);
}

Volume thick_near(Volume volume, const char* map) {
    volume.scale.map = map;
    volume.scale.range = {0, 5};
    volume.opacity_points = {{0, 0.9}, {0.6, 0.3}, {1, 0}};
    volume.unit_length = 2;
    volume.shaded = true;
    return volume;
}

class Fogs {
public:
    Fogs() {
        frame_.width = width;
        frame_.height = height;
        frame_.samples = 4;
        frame_.bounds_min = {0, 0, 0};
        frame_.bounds_max = {edge, edge, edge};
        frame_.background_top = frame_.background_bottom = {0.93F, 0.94F, 0.95F};
        Primitives primitives = ball_.primitives();
        primitives.scalars = {};
        primitives.color = {0.8F, 0.75F, 0.7F, 1};
        frame_.primitives.push_back(primitives);
        frame_.camera.target = {middle, middle, middle};
    }

    test::Picture draw(Renderer& renderer, bool swapped) {
        test::Picture all{columns * width, rows * height, {}};
        all.rgb.resize(std::size_t{3} * columns * width * rows * height);
        for (std::size_t i = 0; i < looks.size(); ++i) {
            look(looks[i], swapped);
            Image image;
            renderer.draw(frame_, image);
            for (std::size_t row = 0; row < height; ++row) {
                const std::size_t at = (i / columns * height + row) * columns * width + i % columns * width;
                std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * row * width), 3 * width,
                            all.rgb.begin() + static_cast<std::ptrdiff_t>(3 * at));
            }
        }
        return all;
    }

private:
    void look(const Look& from, bool swapped) {
        for (std::size_t axis = 0; axis < 3; ++axis) frame_.camera.position[axis] = middle + 20 * from.from[axis];
        frame_.camera.up = from.up;
        frame_.volumes = {thick_near(warm_.volume(from.normal, 80), "inferno"),
                          thick_near(cold_.volume(from.normal, 60), "viridis")};
        if (swapped) std::swap(frame_.volumes[0], frame_.volumes[1]);
    }

    VolumeScene warm_{test::hexahedra({{8, 8, 8}}), [](const Vec3d& p) { return distance(p, {2, 3, 5}); }};
    VolumeScene cold_{test::hexahedra({{8, 8, 8}}), [](const Vec3d& p) { return distance(p, {6, 5, 3}); }};
    Shape ball_ = sphere(1.8, {middle, middle, middle});
    Frame frame_;
};

TEST(GoldenTwoVolumes, AreMixedFromSixSidesInAnyOrder) {
    Fogs fogs;
    for (const Backend backend : available_backends()) {
        Renderer renderer(backend);
        for (const bool swapped : {false, true})
            EXPECT_TRUE(test::matches_golden("two_volumes_from_six_sides", fogs.draw(renderer, swapped),
                                             name_of(backend) + std::string(swapped ? ", swapped" : "")));
    }
}

} // namespace
} // namespace server::render
