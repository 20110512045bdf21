// Lines and points on surfaces have no gaps at any slope. Surfaces and lines well behind a surface are hidden.
#include "backends.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

constexpr double pixel = 3.0 / 240; // size of a pixel of front_view(), in scene units
constexpr double leaning = 0.3;     // angle between the lines and the picture's columns, in radians

class LinesOnSurfaces : public testing::TestWithParam<Backend> {
protected:
    LinesOnSurfaces() {
        frame.background_top = frame.background_bottom = {0, 0, 1};
        frame.bounds_min = {-2, -25, -2};
        frame.bounds_max = {2, 25, 2};
        frame.camera.position = {0, -60, 0};
    }
    // Red sheet from -1 to 1 in x and z, turned by `leaning`. Its triangle edges run along the line, which lies in its
    // middle.
    template <typename Depth>
    static Shape sheet(Depth depth) {
        return grid(2, 1, [&](double u, double v) {
            const double across = 2 * u - 1, along = 2 * v - 1;
            return Vec3f{static_cast<float>(across * std::cos(leaning) - along * std::sin(leaning)),
                         static_cast<float>(depth(across, along)),
                         static_cast<float>(across * std::sin(leaning) + along * std::cos(leaning))};
        });
    }
    static Primitives colored(const Shape& shape, std::array<float, 4> color) {
        Primitives primitives = shape.primitives();
        primitives.lit = false;
        primitives.color = color;
        return primitives;
    }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
    }
    // Pixels that are not fully green within `reach` pixels of the line, except near the line's ends.
    [[nodiscard]] int gaps(double reach) const {
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const double right = x + 0.5 - image.width / 2.0, up = image.height / 2.0 - y - 0.5;
                const double across = right * std::cos(leaning) + up * std::sin(leaning);
                const double along = up * std::cos(leaning) - right * std::sin(leaning);
                if (std::abs(across) < reach && std::abs(along) < 70 && at(x, y)[1] < 250) ++count;
            }
        return count;
    }
    [[nodiscard]] int pixels_with(std::size_t channel) const {
        int count = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) count += image.rgb[i + channel] > 20 ? 1 : 0;
        return count;
    }

    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;
};

INSTANTIATE_TEST_SUITE_P(Backends, LinesOnSurfaces, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LinesOnSurfaces);

struct Bend {
    double left, right, along; // depth per unit: left of the line, right of it, and along it
};

constexpr Bend bends[] = {{0, 0, 0},   {-1, 1, 0.5}, {-8, 8, 0},     {-20, 20, 3}, {8, -8, -2}, {0, 0, 20},
                          {-6, -6, 0}, {5, 5, 1},    {-10, -0.2, 0}, {0.1, -9, 1}, {9, 0.3, 2}};

TEST_P(LinesOnSurfaces, AreWholeAtAnySlopeAndInCreases) {
    for (const float opacity : {1.0F, 0.5F})
        for (const Bend& bend : bends) {
            const Shape shape = sheet([&](double across, double along) {
                return std::abs(across) * (across < 0 ? -bend.left : bend.right) + along * bend.along;
            });
            const std::vector<Vec3f> ends{shape.positions[1], shape.positions[4]};
            for (const float width : {3.0F, 6.0F})
                for (const int samples : {1, 4}) {
                    frame.samples = samples;
                    frame.primitives = {line_between(ends, width, {0, 1, 0, 1}), colored(shape, {1, 0, 0, opacity})};
                    renderer.draw(frame, image);
                    EXPECT_EQ(gaps(width / 2 - 0.75), 0)
                        << "slopes " << bend.left << ", " << bend.right << ", " << bend.along << ", opacity " << opacity
                        << ", width " << width << ", " << samples << " samples";
                }
        }
}

TEST_P(LinesOnSurfaces, AreHiddenWellBehindThem) {
    for (const double slope : {0.0, 1.0, 8.0, 20.0}) {
        const Shape shape = sheet([&](double across, double) { return slope * across; });
        std::vector<Vec3f> ends{shape.positions[1], shape.positions[4]};
        constexpr float width = 3;
        const double behind = (width + 1) * slope * pixel + 1e-4;
        for (Vec3f& end : ends) end[1] += static_cast<float>(behind);
        for (const int samples : {1, 4}) {
            frame.samples = samples;
            ends[0][0] *= 0.9F; // shortens the line, so that its ends are behind the sheet too
            Primitives line = line_between(ends, width, {0, 1, 0, 1});
            frame.primitives = {line, colored(shape, {1, 0, 0, 1})};
            for (Vec3f& end : ends)
                for (const std::size_t axis : {0U, 2U}) end[axis] *= 0.95F;
            renderer.draw(frame, image);
            EXPECT_EQ(pixels_with(1), 0) << slope << ", " << samples << " samples";
        }
    }
}

TEST_P(LinesOnSurfaces, PointsAreWhole) {
    const std::vector<Vec3f> center{{0, 0, 0}};
    const std::vector<Index> one{0};
    Primitives point;
    point.positions = center;
    point.indices = one;
    point.points = true;
    point.lit = false;
    point.color = {0, 1, 0, 1};
    point.point_size = 9;
    for (const double slope : {0.0, 1.0, 5.0, 15.0}) {
        const Shape shape = sheet([&](double across, double along) { return slope * (across + 0.3 * along); });
        frame.primitives = {point, colored(shape, {1, 0, 0, 1})};
        renderer.draw(frame, image);
        for (int y = 117; y < 123; ++y)
            for (int x = 157; x < 163; ++x) EXPECT_GT(at(x, y)[1], 250) << slope << " at " << x << ", " << y;
    }
}

// A disc inside a ball, everywhere less than three pixels behind the ball's surface. Surfaces are drawn a little
// further back so that lines on them stay visible. That offset must not push the steep rim of the ball behind the disc.
TEST_P(LinesOnSurfaces, NothingInAClosedSurfaceIsSeenFromOutside) {
    constexpr double radius = 0.9, rim = 0.85;
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {1, 1, 1};
    frame.camera.position = {0, -5, 0};
    const Shape ball = sphere(radius, {}, 512);
    const double before = std::sqrt(radius * radius - rim * rim);
    const Shape disc = grid(256, 1, [&](double u, double v) {
        const double turn = 2 * std::numbers::pi * u;
        return Vec3f{static_cast<float>(rim * v * std::cos(turn)), static_cast<float>(0.02 - before),
                     static_cast<float>(rim * v * std::sin(turn))};
    });
    const std::vector<Vec3f> ends{{-1.4F, 0, 1.3F}, {1.4F, 0, 1.3F}};
    for (const int samples : {1, 4})
        for (const float width : {0.0F, 1.5F, 10.0F}) { // width of a line elsewhere in the picture; 0 for no line
            frame.samples = samples;
            frame.primitives = {colored(disc, {0, 1, 0, 1}), colored(ball, {1, 0, 0, 1})};
            if (width > 0) frame.primitives.push_back(line_between(ends, width, {1, 0, 1, 1}));
            renderer.draw(frame, image);
            EXPECT_EQ(pixels_with(1), 0) << samples << " samples, a line " << width << " pixels wide";
        }
}

// The green strip lies close behind a steep transparent red sheet. A wide line elsewhere must not change their order.
TEST_P(LinesOnSurfaces, TransparentSurfacesKeepTheirOrder) {
    frame.background_top = frame.background_bottom = {0, 0, 0};
    const Shape steep = grid(1, 1, [](double u, double v) {
        return Vec3f{static_cast<float>(2 * u - 1), static_cast<float>(6 * (2 * u - 1)), static_cast<float>(2 * v - 1)};
    });
    const Shape strip = grid(1, 1, [](double u, double v) {
        return Vec3f{static_cast<float>(0.1 * u - 0.05), 0.32F, static_cast<float>(v - 0.5)};
    });
    const std::vector<Vec3f> ends{{-1.4F, 0, 1.3F}, {1.4F, 0, 1.3F}};
    frame.primitives = {colored(strip, {0, 1, 0, 0.9F}), colored(steep, {1, 0, 0, 0.9F}),
                        line_between(ends, 10, {1, 1, 1, 1})};
    frame.samples = 4;
    renderer.draw(frame, image);
    for (int y = 100; y < 140; ++y)
        for (int x = 156; x < 164; ++x) {
            EXPECT_NEAR(at(x, y)[0], 0.9 * 255, 3) << "at " << x << ", " << y;
            EXPECT_NEAR(at(x, y)[1], 0.09 * 255, 3) << "at " << x << ", " << y;
        }
}

// The transparent surface coincides with an opaque one and must show everywhere, at any sample position.
TEST_P(LinesOnSurfaces, ATransparentSurfaceOnAnOpaqueOneIsSeenAllOver) {
    const Shape ball = sphere(0.9, {0.1, 0, 0.05}, 64);
    const std::vector<Vec3f> center{{-1.5F, 0, -1.2F}};
    const std::vector<Index> one{0};
    Primitives point; // a point elsewhere in the picture, drawn among the transparent layers
    point.positions = center;
    point.indices = one;
    point.points = true;
    point.point_size = 3;
    point.lit = false;
    point.color = {0, 0, 1, 1};
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {1, 1, 1};
    frame.camera.position = {2, -4, 1.5};
    for (const int samples : {1, 4})
        for (const bool with_point : {false, true}) {
            frame.samples = samples;
            frame.primitives = {colored(ball, {1, 0, 0, 1}), colored(ball, {0, 1, 0, 0.5F})};
            if (with_point) frame.primitives.push_back(point);
            renderer.draw(frame, image);
            int red = 0, mixed = 0;
            for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
                red += image.rgb[i] > 200 ? 1 : 0;
                mixed += std::abs(image.rgb[i] - 128) < 8 && std::abs(image.rgb[i + 1] - 128) < 8 ? 1 : 0;
            }
            EXPECT_GT(mixed, 10000) << samples;
            EXPECT_EQ(red, 0) << samples << " samples, with a point: " << with_point;
        }
}

} // namespace
} // namespace server::render
