// Ambient occlusion: isolated surfaces keep all light, right-angled corners lose half, and only opaque surfaces take
// part.
#include "backends.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr double full = 255 * 0.6; // byte value of an unoccluded white surface at ambient 2, without other lights

class OcclusionTest : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    std::vector<Shape> shapes;

    OcclusionTest() {
        shapes.reserve(64);
        frame.lighting = {2, 0, 0};
        frame.background_top = frame.background_bottom = {0, 0, 0};
    }
    Primitives& add(Shape shape) {
        shapes.push_back(std::move(shape));
        Primitives primitives = shapes.back().primitives();
        primitives.scalars = {};
        primitives.normals = {};
        primitives.color = {1, 1, 1, 1};
        frame.primitives.push_back(primitives);
        return frame.primitives.back();
    }
    Image draw(double radius, float strength = 1) {
        frame.occlusion = {radius, strength};
        Image image;
        renderer.draw(frame, image);
        return image;
    }
    // Largest difference of any byte between the pictures with and without occlusion.
    int change(double radius) {
        const Image with = draw(radius), without = draw(0);
        int most = 0;
        for (std::size_t i = 0; i < with.rgb.size(); ++i) most = std::max(most, std::abs(with.rgb[i] - without.rgb[i]));
        return most;
    }
    // Adds the floor z = 0 and the wall y = 0, which meet in the x axis, and looks at the corner at 45 degrees.
    void add_corner() {
        add(grid(1, 1, [](double u, double v) {
            return Vec3f{static_cast<float>(8 * u - 4), static_cast<float>(-4 * v), 0};
        }));
        add(grid(1, 1, [](double u, double v) {
            return Vec3f{static_cast<float>(8 * u - 4), 0, static_cast<float>(4 * v)};
        }));
        frame.camera.position = {0, -5, 5};
        frame.camera.target = {0, 0, 0};
        frame.bounds_min = {-4, -4, 0};
        frame.bounds_max = {4, 0, 4};
    }
    // Brightness at the distance `away` from the corner, on the wall; negative on the floor. 1 is unoccluded.
    [[nodiscard]] double light(const Image& image, double away) const {
        const double row = image.height * (0.5 - away / std::sqrt(2.0) / frame.camera.parallel_height);
        const auto y = static_cast<std::size_t>(row);
        return image.rgb[3 * (y * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(image.width) / 2)] /
               full;
    }
};

TEST_P(OcclusionTest, APlaneAloneKeepsAllLightFromAnywhere) {
    add(grid(7, 5, [](double u, double v) {
        return Vec3f{static_cast<float>(40 * u - 20), static_cast<float>(40 * v - 20), 0};
    }));
    frame.bounds_min = {-20, -20, 0};
    frame.bounds_max = {20, 20, 0};
    for (const Vec3d& eye : {Vec3d{0, 0, 9}, Vec3d{3, -6, 4}, Vec3d{-7, 2, 0.8}, Vec3d{9, 9, 2}})
        for (const bool parallel : {false, true})
            for (const int samples : {1, 4}) {
                frame.camera.position = eye;
                frame.camera.up = eye[0] == 0 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
                frame.camera.parallel = parallel;
                frame.samples = samples;
                EXPECT_EQ(change(1), 0) << "from " << eye[0] << " " << eye[1] << " " << eye[2] << ", parallel "
                                        << parallel << ", samples " << samples;
            }
}

TEST_P(OcclusionTest, ABallAloneKeepsAllLight) {
    add(sphere(1));
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        EXPECT_LE(change(0.5), 2);
    }
}

TEST_P(OcclusionTest, ACornerLosesHalfOfTheLight) {
    add_corner();
    frame.width = 960;
    frame.height = 720;
    frame.samples = 4;
    const Image image = draw(0.7);
    // 0.01 is about two pixels. The other side hides almost half of the hemisphere there.
    for (const double away : {0.01, -0.01}) {
        EXPECT_GT(light(image, away), 0.5);
        EXPECT_LT(light(image, away), 0.6);
    }
}

TEST_P(OcclusionTest, ACornerIsTheSameOnBothSidesAndBrighterFurtherOff) {
    add_corner();
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        const Image image = draw(1);
        double last = 0;
        for (double away = 0.05; away < 0.95; away += 0.1) {
            EXPECT_NEAR(light(image, away), light(image, -away), 0.03) << away;
            EXPECT_GT(light(image, away), last - 0.005) << away;
            last = light(image, away);
        }
        EXPECT_GT(light(image, 0.5), 0.8);
        EXPECT_EQ(light(image, 1.05), 1);
        EXPECT_EQ(light(image, -1.05), 1);
    }
}

TEST_P(OcclusionTest, ReachesAsFarAsTheRadiusAndIsAsDarkAsTheStrength) {
    add_corner();
    frame.width = 640;
    frame.height = 480;
    frame.samples = 4;
    const Image narrow = draw(0.4);
    EXPECT_EQ(light(narrow, 0.45), 1);
    const Image wide = draw(0.8), strong = draw(0.8, 2);
    EXPECT_LT(light(wide, 0.3), 0.97);
    for (const double away : {0.1, 0.2, 0.3}) {
        EXPECT_NEAR(light(narrow, away / 2), light(wide, away), 0.035) << "the same in units of the radius";
        EXPECT_NEAR(light(strong, away), std::pow(light(wide, away), 2), 0.02);
    }
}

TEST_P(OcclusionTest, IsTheSameAtAnyResolutionAndWhileSomethingMoves) {
    add_corner();
    frame.samples = 4;
    const Image still = draw(0.8);
    frame.samples = 1;
    const Image moving = draw(0.8);
    frame.width *= 3;
    frame.height *= 3;
    const Image large = draw(0.8);
    for (double away = -0.75; away < 0.8; away += 0.1) {
        EXPECT_NEAR(light(still, away), light(moving, away), 0.03) << away;
        EXPECT_NEAR(light(still, away), light(large, away), 0.03) << away;
    }
}

// With a larger radius the samples would lie too far apart, so a quarter of the picture's height is the maximum.
TEST_P(OcclusionTest, AVeryLargeRadiusIsThatOfAQuarterOfThePicture) {
    add_corner();
    frame.samples = 4;
    const Image huge = draw(30), quarter = draw(0.25 * frame.camera.parallel_height);
    for (const double away : {-0.6, -0.3, -0.1, 0.1, 0.3, 0.6})
        EXPECT_NEAR(light(huge, away), light(quarter, away), 0.03) << away;
    EXPECT_EQ(light(huge, 0.8), 1);
}

// Wide perspective: surfaces seen obliquely at the picture's sides are as dark as in the middle.
TEST_P(OcclusionTest, ACornerIsTheSameAllAlongItInAPerspective) {
    add_corner();
    frame.camera.parallel = false;
    frame.camera.fov_degrees = 90;
    frame.camera.position = {0, -1.2, 1.2};
    frame.width = 640;
    frame.height = 480;
    frame.samples = 4;
    const Image image = draw(0.4);
    const auto seen = [&](double along, double away, bool wall) {
        const Vec3d from{along, (wall ? 0 : -away) + 1.2, (wall ? away : 0) - 1.2}; // vector from the eye to the place
        const double depth = (from[1] - from[2]) / std::numbers::sqrt2, up = (from[1] + from[2]) / std::numbers::sqrt2;
        const auto x = static_cast<std::size_t>(320 + 240 * from[0] / depth);
        const auto y = static_cast<std::size_t>(240 - 240 * up / depth);
        return image.rgb[3 * (y * 640 + x)] / full;
    };
    for (const bool wall : {false, true})
        for (const double away : {0.1, 0.15, 0.2}) {
            EXPECT_LT(seen(0, away, wall), 0.98);
            for (const double along : {-1.4, -0.7, 0.7, 1.4})
                EXPECT_NEAR(seen(along, away, wall), seen(0, away, wall), 0.03) << along << " " << away << " " << wall;
        }
}

// The eye stays in place while the camera turns: a place keeps its darkness wherever it is in the picture.
TEST_P(OcclusionTest, APlaceIsAsDarkAnywhereInAPerspective) {
    add_corner();
    frame.camera.parallel = false;
    frame.camera.fov_degrees = 100;
    frame.camera.position = {0, -1.6, 0.6};
    frame.width = frame.height = 480;
    frame.samples = 4;
    const double half = std::tan(frame.camera.fov_degrees * std::numbers::pi / 360);
    const auto seen = [&](const Image& image, const Vec3d& place) {
        const Vec3d to = plus(place, frame.camera.position, -1);
        const Vec3d ahead = unit_of(plus(frame.camera.target, frame.camera.position, -1));
        const Vec3d right = unit_of(cross_of(ahead, frame.camera.up)), up = cross_of(right, ahead);
        const auto dot = [&](const Vec3d& v) { return to[0] * v[0] + to[1] * v[1] + to[2] * v[2]; };
        const auto x = static_cast<std::size_t>(240 * (1 + dot(right) / dot(ahead) / half));
        const auto y = static_cast<std::size_t>(240 * (1 - dot(up) / dot(ahead) / half));
        return image.rgb[3 * (y * 480 + x)] / full;
    };
    const std::vector<Vec3d> places{{0, -0.1, 0}, {0, -0.25, 0}, {0, 0, 0.1}, {0, 0, 0.25}, {0.3, 0, 0.1}};
    std::vector<double> ahead;
    for (const Vec3d& target :
         {Vec3d{0, 0, 0}, {1.1, 0, 0}, {-1.1, 0, 0}, {0, 0, 0.6}, {0, -0.8, -0.3}, {1.1, 0, 0.6}}) {
        frame.camera.target = target;
        const Image image = draw(0.6);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double light = seen(image, places[i]);
            if (ahead.size() <= i) ahead.push_back(light);
            EXPECT_LT(light, 0.98);
            EXPECT_NEAR(light, ahead[i], 0.03) << "place " << i << ", looking to " << testing::PrintToString(target);
        }
    }
}

// Brightness is constant along the corner: the sampling pattern, which differs from pixel to pixel, is not visible.
TEST_P(OcclusionTest, IsEvenAlongACorner) {
    add_corner();
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        const Image image = draw(0.8);
        for (const double away : {0.1, 0.3}) {
            const auto y =
                static_cast<std::size_t>(image.height * (0.5 - away / std::sqrt(2.0) / frame.camera.parallel_height));
            int low = 255, high = 0;
            for (std::size_t x = 60; x < 260; ++x) {
                const int value = image.rgb[3 * (y * static_cast<std::size_t>(image.width) + x)];
                low = std::min(low, value);
                high = std::max(high, value);
            }
            EXPECT_LE(high - low, 3) << "samples " << samples << ", away " << away;
        }
    }
}

TEST_P(OcclusionTest, ABallOnAPlaneShadesItAllAround) {
    add(grid(1, 1, [](double u, double v) {
        return Vec3f{static_cast<float>(4 * u - 2), static_cast<float>(4 * v - 2), 0};
    }));
    add(sphere(0.4, {0, 0, 0.4}));
    frame.camera.position = {0, 0, 5};
    frame.camera.up = {0, 1, 0};
    frame.bounds_min = {-2, -2, 0};
    frame.bounds_max = {2, 2, 0.8};
    frame.samples = 4;
    const Image image = draw(0.8);
    const auto around = [&](double distance, double angle) {
        const double pixels = image.height / frame.camera.parallel_height * distance;
        const auto x = static_cast<std::size_t>(160 + pixels * std::cos(angle));
        const auto y = static_cast<std::size_t>(120 + pixels * std::sin(angle));
        return image.rgb[3 * (y * 320 + x)] / full;
    };
    for (int i = 0; i < 12; ++i) {
        const double angle = 0.5 + i * std::numbers::pi / 6;
        EXPECT_NEAR(around(0.5, angle), around(0.5, 0.5), 0.03) << i;
        EXPECT_LT(around(0.45, angle), around(0.52, angle) - 0.01) << i;
        EXPECT_LT(around(0.52, angle), around(0.7, angle) - 0.01) << i;
        EXPECT_EQ(around(1.25, angle), 1) << i;
    }
}

// Pixels on the ball's outline cover both the ball and the plane.
TEST_P(OcclusionTest, ABallFarInFrontOfAPlaneHasNoHalo) {
    add(square(1));
    add(sphere(0.5, {0, -1, 0}));
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        EXPECT_LE(change(0.3), 4) << samples;
    }
}

// The corner far behind the ball must not darken the ball's outline.
TEST_P(OcclusionTest, AnOutlineInFrontOfACornerKeepsItsOwnLight) {
    add_corner();
    add(sphere(0.3, {0, -2, 2}));
    frame.samples = 4;
    const Image image = draw(0.6);
    const double radius = 240 / 3.0 * 0.3;
    for (int i = 0; i < 64; ++i) {
        const double angle = i * std::numbers::pi / 32;
        const auto x = static_cast<std::size_t>(160 + (radius - 2) * std::cos(angle));
        const auto y = static_cast<std::size_t>(120 + (radius - 2) * std::sin(angle));
        EXPECT_GE(image.rgb[3 * (y * 320 + x)] / full, 0.97) << i;
    }
}

// A pixel on the outline must use the occlusion of its own surface, not of a neighbor far behind. The ball is red and
// the corner blue, so each channel shows the share of one surface times its light.
TEST_P(OcclusionTest, ABallsOutlineHasNoLightOfTheCornerBehindNorTheCornerOfTheBall) {
    add_corner();
    for (Primitives& primitives : frame.primitives) primitives.color = {0, 0, 1, 1};
    const auto drawn = [&](double radius) {
        std::vector<Image> images;
        for (const int samples : {1, 4}) {
            frame.samples = samples;
            images.push_back(draw(radius));
        }
        return images;
    };
    const std::vector<Image> alone = drawn(0.6);
    add(sphere(0.3, {0, -2, 2})).color = {1, 0, 0, 1};
    const std::vector<Image> shaded = drawn(0.6), plain = drawn(0);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t pixel = 0; pixel < plain[i].rgb.size(); pixel += 3) {
            const int red = plain[i].rgb[pixel], blue = plain[i].rgb[pixel + 2];
            ASSERT_GE(shaded[i].rgb[pixel], 0.96 * red - 2) << "pixel " << pixel / 3 << ", " << i;
            ASSERT_NEAR(shaded[i].rgb[pixel + 2], alone[i].rgb[pixel + 2] * blue / full, 0.12 * full)
                << "pixel " << pixel / 3 << ", " << i;
        }
}

TEST_P(OcclusionTest, LinesPointsAndWhatIsTransparentNeitherShadeNorAreShaded) {
    add(square(0.5));
    Shape line;
    line.positions = {{-0.8F, 0.3F, 0}, {0.8F, 0.45F, 0.3F}};
    line.indices = {0, 1};
    add(line).lines = true;
    add(line).points = true;
    add(square(0.4)).color = {1, 0, 0, 0.5F};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        EXPECT_EQ(change(0.5), 0);
    }
}

TEST_P(OcclusionTest, AVolumeNeitherShadesNorIsShaded) {
    VolumeScene fog(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    Volume volume = fog.volume({0, 1, 0}, 30);
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0.5}, {1, 0.5}};
    volume.unit_length = 2;
    frame.volumes = {volume};
    frame.bounds_min = {0, 0, 0};
    frame.bounds_max = {4, 4, 4};
    frame.camera.position = {2, -9, 2};
    frame.camera.target = {2, 2, 2};
    frame.camera.parallel_height = 6;
    add(grid(1, 1, [](double u, double v) { return Vec3f{static_cast<float>(4 * u), 2, static_cast<float>(4 * v)}; }));
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        EXPECT_EQ(change(1), 0);
    }
}

TEST_P(OcclusionTest, SlicesKeepTheirColorsButShadeWhatIsLit) {
    add_corner();
    frame.primitives[0].lit = false; // primitives[0] is the floor
    frame.samples = 4;
    const Image image = draw(0.8);
    EXPECT_LT(light(image, 0.1), 0.85);
    EXPECT_EQ(light(image, -0.1) * full, 255);
}

TEST_P(OcclusionTest, WhatAClipPlaneTookAwayShadesNothing) {
    add_corner();
    frame.samples = 4;
    EXPECT_LT(light(draw(0.8), -0.1), 0.85);
    frame.clip = {{0, -1, 0, -0.001F}}; // removes the wall
    EXPECT_EQ(light(draw(0.8), -0.1), 1);
    EXPECT_EQ(change(0.8), 0);
}

INSTANTIATE_TEST_SUITE_P(, OcclusionTest, testing::ValuesIn(available_backends()), name_of_test);

} // namespace
} // namespace server::render
