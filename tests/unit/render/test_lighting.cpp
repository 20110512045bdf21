// The lights of a frame against what they are said to add.
#include "backends.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace ciel::render {
namespace {

constexpr double gray = 0.5;

const double key_length = std::sqrt(0.45 * 0.45 + 0.65 * 0.65 + 0.6 * 0.6);
const Vec3d key{-0.45 / key_length, 0.65 / key_length, 0.6 / key_length};

// Of a surface with this normal along the eye's axes: right, up, towards the viewer.
double expected(const Lighting& lighting, const Vec3d& normal = {0, 0, 1}) {
    const double to_key = normal[0] * key[0] + normal[1] * key[1] + normal[2] * key[2];
    const double wrapped = 0.5 + 0.5 * to_key;
    const double half = std::max(0.0, (normal[2] + to_key) / std::sqrt(2 + 2 * key[2])); // cosine to key + viewer
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

    // Polygons are wound about the normals of their vertices, which here look at the viewer or away.
    void wind(bool to_viewer) {
        if (std::exchange(winds_to_viewer, to_viewer) != to_viewer)
            std::reverse(shape.indices.begin(), shape.indices.end());
    }

    double middle(Primitives mesh, std::size_t right = 0) {
        mesh.scalars = {};
        mesh.color = {gray, gray, gray, 1};
        frame.primitives = {mesh};
        Image image;
        renderer.draw(frame, image);
        return image.rgb[3 * (120 * 320 + 160 + right)] / 255.0;
    }
};

TEST_P(LightingTest, EachLightAddsItsStrength) {
    for (const Lighting lighting : {Lighting{}, Lighting{0, 1, 0}, Lighting{0, 0, 1}, Lighting{1, 0, 0},
                                    Lighting{0.5F, 2, 0.25F}, Lighting{0, 0, 0}}) {
        frame.lighting = lighting;
        EXPECT_NEAR(middle(shape.mesh()), expected(lighting), 0.003)
            << lighting.ambient << " " << lighting.headlight << " " << lighting.key_light;
    }
}

// The highlight's own direction is among them; a color of its own and a back side take other programs.
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
                    EXPECT_NEAR(middle(shape.mesh()), expected(lighting, normal), 0.003)
                        << normal[0] << " " << normal[1] << " " << normal[2] << ", lights " << lighting.ambient << " "
                        << lighting.headlight << " " << lighting.key_light << ", side " << side << ", " << clipped;
                }
}

// The rim of a smooth shape: its polygons still face the viewer where the field's normals no longer do.
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
                EXPECT_NEAR(middle(shape.mesh()), expected({}, seen), 0.003)
                    << away << ", side " << side << ", " << clipped;
            }
}

TEST_P(LightingTest, WhatIsUnlitHasItsOwnColor) {
    frame.lighting = {0, 0, 0};
    Primitives mesh = shape.mesh();
    mesh.lit = false;
    EXPECT_NEAR(middle(mesh), gray, 0.003);
}

TEST_P(LightingTest, PointsAreLitAsBallsOrNotAtAll) {
    Shape point;
    point.positions = {{0, 0, 0}};
    point.indices = {0};
    Primitives mesh = point.mesh();
    mesh.points = true;
    mesh.point_size = 41; // its middle is a pixel
    EXPECT_NEAR(middle(mesh), gray, 0.01);
    for (const std::size_t right : {8, 14, 18}) { // of a ball whose rim is 21 from its middle, a corner of pixels
        const double side = std::hypot(static_cast<double>(right) + 0.5, 0.5) / 21;
        EXPECT_NEAR(middle(mesh, right), gray * (0.55 + 0.45 * std::sqrt(1 - side * side)), 0.004) << right;
    }
    frame.lighting = {1, 0, 1};
    EXPECT_NEAR(middle(mesh), 0.55 * gray, 0.01);
    frame.lighting = {0, 0, 0};
    mesh.lit = false;
    EXPECT_NEAR(middle(mesh), gray, 0.003);
}

INSTANTIATE_TEST_SUITE_P(, LightingTest, testing::ValuesIn(available_backends()), name_of_test);

} // namespace
} // namespace ciel::render
