// The brightness of each light of a frame, against its formula.
#include "backends.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace server::render {
using namespace ciel;
namespace {

constexpr double gray = 0.5;

const double key_length = std::sqrt(0.45 * 0.45 + 0.65 * 0.65 + 0.6 * 0.6);
const Vec3d key{-0.45 / key_length, 0.65 / key_length, 0.6 / key_length};

// Expected brightness (0 to 1) of a surface. `normal` is in eye space: right, up, towards the viewer.
double expected(const Lighting& lighting, const Vec3d& normal = {0, 0, 1}) {
    const double to_key = normal[0] * key[0] + normal[1] * key[1] + normal[2] * key[2];
    const double wrapped = 0.5 + 0.5 * to_key;
    // Cosine between the normal and the half vector of key light and viewer.
    const double half = std::max(0.0, (normal[2] + to_key) / std::sqrt(2 + 2 * key[2]));
    return gray * (0.30 * lighting.ambient + 0.38 * lighting.headlight * normal[2] +
                   0.40 * lighting.key_light * wrapped * wrapped) +
           0.10 * lighting.key_light * std::pow(half, 40);
}

class LightingTest : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Shape shape = square(0);
    bool winds_to_viewer = true;

    // Polygons must be wound about their vertex normals, which face the viewer or look away in these tests.
    void wind(bool to_viewer) {
        if (std::exchange(winds_to_viewer, to_viewer) != to_viewer)
            std::reverse(shape.indices.begin(), shape.indices.end());
    }

    double middle(Primitives primitives, std::size_t right = 0) {
        primitives.scalars = {};
        primitives.color = {gray, gray, gray, 1};
        frame.primitives = {primitives};
        Image image;
        renderer.draw(frame, image);
        return image.rgb[3 * (120 * 320 + 160 + right)] / 255.0;
    }
};

TEST_P(LightingTest, EachLightAddsItsStrength) {
    for (const Lighting lighting : {Lighting{}, Lighting{0, 1, 0}, Lighting{0, 0, 1}, Lighting{1, 0, 0},
                                    Lighting{0.5F, 2, 0.25F}, Lighting{0, 0, 0}}) {
        frame.lighting = lighting;
        EXPECT_NEAR(middle(shape.primitives()), expected(lighting), 0.003)
            << lighting.ambient << " " << lighting.headlight << " " << lighting.key_light;
    }
}

// The normals include the direction of the strongest highlight. Clip planes and back sides are tested because they use
// other shader programs.
TEST_P(LightingTest, EachLightAddsWhatTheNormalTakesOfIt) {
    const double long_half = std::hypot(key[0], key[1], key[2] + 1);
    const Vec3d half{key[0] / long_half, key[1] / long_half, (key[2] + 1) / long_half};
    for (const Vec3d& normal : {half, key, Vec3d{0.6, 0, 0.8}, Vec3d{-0.8, 0, 0.6}, Vec3d{0, -0.96, 0.28}})
        for (const Lighting lighting : {Lighting{}, Lighting{0, 1, 0}, Lighting{0, 0, 1}, Lighting{0.5F, 1.5F, 0.25F}})
            for (const float side : {1.0F, -1.0F})
                for (const bool clipped : {false, true}) {
                    frame.lighting = lighting;
                    frame.clip.clear();
                    if (clipped) frame.clip.push_back({0, 0, 0, 1});
                    shape.normals.assign(shape.positions.size(),
                                         {side * static_cast<float>(normal[0]), side * static_cast<float>(-normal[2]),
                                          side * static_cast<float>(normal[1])});
                    wind(side > 0);
                    EXPECT_NEAR(middle(shape.primitives()), expected(lighting, normal), 0.003)
                        << normal[0] << " " << normal[1] << " " << normal[2] << ", lights " << lighting.ambient << " "
                        << lighting.headlight << " " << lighting.key_light << ", side " << side << ", " << clipped;
                }
}

// On the rim of a smooth shape, vertex normals may look away from the viewer while the polygon still faces it.
TEST_P(LightingTest, NormalsThatLookAwayAreMirrored) {
    const double across = std::hypot(key[0], key[1]);
    for (const double away : {0.02, 0.3})
        for (const float side : {1.0F, -1.0F})
            for (const bool clipped : {false, true}) {
                const double along = std::sqrt(1 - away * away) / across;
                const Vec3d seen{key[0] * along, key[1] * along, away};
                frame.clip.clear();
                if (clipped) frame.clip.push_back({0, 0, 0, 1});
                shape.normals.assign(shape.positions.size(),
                                     {side * static_cast<float>(seen[0]), side * static_cast<float>(away),
                                      side * static_cast<float>(seen[1])});
                wind(side > 0);
                EXPECT_NEAR(middle(shape.primitives()), expected({}, seen), 0.003)
                    << away << ", side " << side << ", " << clipped;
            }
}

TEST_P(LightingTest, WhatIsUnlitHasItsOwnColor) {
    frame.lighting = {0, 0, 0};
    Primitives primitives = shape.primitives();
    primitives.lit = false;
    EXPECT_NEAR(middle(primitives), gray, 0.003);
}

TEST_P(LightingTest, PointsAreLitAsBallsOrNotAtAll) {
    Shape point;
    point.positions = {{0, 0, 0}};
    point.indices = {0};
    Primitives primitives = point.primitives();
    primitives.points = true;
    primitives.point_size = 41; // odd, so that the point's center is the center of a pixel
    EXPECT_NEAR(middle(primitives), gray, 0.01);
    // Pixels to the right of the center. The point is shaded as a ball with a radius of 21 pixels.
    for (const std::size_t right : {8, 14, 18}) {
        const double side = std::hypot(static_cast<double>(right) + 0.5, 0.5) / 21;
        EXPECT_NEAR(middle(primitives, right), gray * (0.55 + 0.45 * std::sqrt(1 - side * side)), 0.004) << right;
    }
    frame.lighting = {1, 0, 1};
    EXPECT_NEAR(middle(primitives), 0.55 * gray, 0.01);
    frame.lighting = {0, 0, 0};
    primitives.lit = false;
    EXPECT_NEAR(middle(primitives), gray, 0.003);
}

INSTANTIATE_TEST_SUITE_P(, LightingTest, testing::ValuesIn(available_backends()), name_of_test);

} // namespace
} // namespace server::render
