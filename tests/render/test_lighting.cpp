// The lights of a frame against what they are said to add.
#include "scenes.hpp"

#include <gtest/gtest.h>

namespace ciel::render {
namespace {

constexpr double gray = 0.5;

// Of a plane towards the viewer.
double expected(const Lighting& lighting) {
    const double key_z = 0.6 / std::sqrt(0.45 * 0.45 + 0.65 * 0.65 + 0.6 * 0.6);
    const double wrapped = 0.5 + 0.5 * key_z;
    const double half = (1 + key_z) / std::sqrt(2 + 2 * key_z); // angle between the plane's normal and key + viewer
    return gray *
               (0.30 * lighting.ambient + 0.38 * lighting.headlight + 0.40 * lighting.key_light * wrapped * wrapped) +
           0.10 * lighting.key_light * std::pow(half, 40);
}

class LightingTest : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Shape shape = square(0);

    double middle(Mesh mesh) {
        mesh.scalars = {};
        mesh.color = {gray, gray, gray, 1};
        frame.meshes = {mesh};
        Image image;
        renderer.draw(frame, image);
        return image.rgb[static_cast<std::size_t>(3 * (120 * 320 + 160))] / 255.0;
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

TEST_P(LightingTest, WhatIsUnlitHasItsOwnColour) {
    frame.lighting = {0, 0, 0};
    Mesh mesh = shape.mesh();
    mesh.lit = false;
    EXPECT_NEAR(middle(mesh), gray, 0.003);
}

TEST_P(LightingTest, PointsAreLitAsBallsOrNotAtAll) {
    Shape point;
    point.positions = {{0, 0, 0}};
    point.indices = {0};
    Mesh mesh = point.mesh();
    mesh.points = true;
    mesh.point_size = 41; // its middle is a pixel
    EXPECT_NEAR(middle(mesh), gray, 0.01);
    frame.lighting = {1, 0, 1};
    EXPECT_NEAR(middle(mesh), 0.55 * gray, 0.01);
    frame.lighting = {0, 0, 0};
    mesh.lit = false;
    EXPECT_NEAR(middle(mesh), gray, 0.003);
}

INSTANTIATE_TEST_SUITE_P(, LightingTest, testing::ValuesIn(available_backends()), [](const auto& parameter) {
    std::string name = name_of(parameter.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

} // namespace
} // namespace ciel::render
