// The shader's color mapping against color_scale.hpp's: pictures of a square whose scalar is known at every pixel.
#include "backends.hpp"
#include "color/color_map.hpp"
#include "color/color_scale.hpp"
#include "scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace server::render {
using namespace ciel;
namespace {

constexpr int width = 400, height = 40;

// Rectangle in the plane y = 0 over the whole picture. Its scalar rises linearly from `left` to `right`.
Shape band(float left, float right, Index columns = 1) {
    Shape shape = grid(columns, 1, [](double u, double v) {
        return Vec3f{static_cast<float>(20 * u - 10), 0, static_cast<float>(2 * v - 1)};
    });
    for (const Vec3f& p : shape.positions) shape.scalars.push_back(left + (p[0] + 10) / 20 * (right - left));
    return shape;
}

class ColorScalePicture : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Image image;

    void draw(const std::vector<Primitives>& all) {
        Frame frame = front_view(width, height);
        frame.camera.parallel_height = 2; // 20 units wide
        frame.primitives = all;
        renderer.draw(frame, image);
    }
    void draw(const Shape& shape, const color::ColorScale& scale, float opacity = 1) {
        Primitives primitives = shape.primitives();
        primitives.lit = false;
        primitives.scale = scale;
        primitives.color[3] = opacity;
        draw({primitives});
    }
    [[nodiscard]] color::Rgb8 at(int x, int y = height / 2) const {
        const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * width + x)];
        return {p[0], p[1], p[2]};
    }
    // Compares every pixel of the middle row with color_of, except pixels over which the color jumps.
    void expect_rule(const color::ColorScale& scale, double left, double right, int tolerance) {
        for (int x = 0; x < width; ++x) {
            const auto value = [&](double pixel) { return left + pixel / width * (right - left); };
            const color::Rgb8 before = color::color_of(scale, value(x)), after = color::color_of(scale, value(x + 1));
            const color::Rgb8 wanted = color::color_of(scale, value(x + 0.5)), seen = at(x);
            for (std::size_t k = 0; k < 3; ++k) {
                if (std::abs(before[k] - after[k]) > 12) continue;
                ASSERT_NEAR(seen[k], wanted[k], tolerance) << "pixel " << x << ", channel " << k;
            }
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, ColorScalePicture, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ColorScalePicture);

color::ColorScale scale_of(const char* map, std::array<double, 2> range) {
    color::ColorScale scale;
    scale.map = map;
    scale.range = range;
    return scale;
}

// The values are doubles around 2^20 that differ by at most 2^-9. As floats they would all be equal.
TEST_P(ColorScalePicture, DoublesFarFromZeroHaveTheColorsOfTheSameDoublesAroundZero) {
    const double far = std::ldexp(1, 20);
    for (const int steps : {0, 7})
        for (const float opacity : {1.0F, 0.5F}) {
            Shape shape = band(-0.25F, 0.25F, 64);
            std::vector<double> near_zero(shape.scalars.size()), far_away(shape.scalars.size());
            for (std::size_t i = 0; i < near_zero.size(); ++i) {
                near_zero[i] = std::ldexp(std::round(std::ldexp(double{shape.scalars[i]}, 20)), -28);
                far_away[i] = far + near_zero[i];
            }
            const double reach = std::ldexp(0.125, -8);
            color::ColorScale scale;
            scale.range = {-reach, reach};
            scale.steps = steps;
            scale.below = color::Rgb8{255, 0, 0};
            scale.above = color::Rgb8{0, 255, 0};
            Primitives primitives = shape.primitives();
            primitives.lit = false;
            primitives.color[3] = opacity;
            primitives.scale = scale;
            primitives.scalars = near_zero;
            draw({primitives});
            const Image wanted = image;
            primitives.scale.range = {far - reach, far + reach};
            primitives.scalars = far_away;
            primitives.scalar_origin = far + 0.001; // any number near the values
            draw({primitives});
            std::size_t unlike = 0;
            for (std::size_t i = 0; i < image.rgb.size(); ++i) unlike += std::abs(image.rgb[i] - wanted.rgb[i]) > 2;
            EXPECT_LE(unlike, 3U * height * 9) << "at the ends of the steps alone; " << steps << ' ' << opacity;
            if (steps == 0 && opacity == 1) {
                EXPECT_EQ(at(10), *scale.below);
                EXPECT_EQ(at(width - 10), *scale.above);
            }
        }
}

// Absolute pressure in a slow flow: the range is only 26 float32 steps wide. Tests a smooth scale and one of 13 colors.
TEST_P(ColorScalePicture, OfASmallRangeBesideItsValuesIsAsSmooth) {
    const double low = 101325 - 13.0 / 128, high = 101325 + 13.0 / 128;
    for (const int steps : {0, 13})
        for (const float opacity : {1.0F, 0.999F}) { // 0.999 selects depth peeling
            color::ColorScale scale = scale_of("turbo", {low, high});
            scale.steps = steps;
            draw(band(static_cast<float>(low), static_cast<float>(high)), scale, opacity);
            expect_rule(scale, low, high, 4);
        }
}

TEST_P(ColorScalePicture, EveryMapIsTheTableBothWaysRound) {
    for (const std::string& name : color::color_map_names())
        for (const bool reverse : {false, true}) {
            SCOPED_TRACE(name);
            color::ColorScale scale = scale_of(name.c_str(), {-1, 3});
            scale.reverse = reverse;
            draw(band(-1, 3), scale);
            expect_rule(scale, -1, 3, 3);
        }
}

// Only two vertices: the value must be interpolated and looked up, not its color or its logarithm.
TEST_P(ColorScalePicture, LogarithmIsTakenAtEachPixel) {
    color::ColorScale scale = scale_of("viridis", {1, 1e6F});
    scale.log = true;
    draw(band(1, 1e6F), scale);
    expect_rule(scale, 1, 1e6, 3);
    draw(band(-10, 1e6F), scale); // values of zero and below have the lowest color
    expect_rule(scale, -10, 1e6, 3);
}

TEST_P(ColorScalePicture, StepsAreSharpAndHaveTheirColorsExactly) {
    for (const int steps : {2, 3, 7, 16})
        for (const bool log : {false, true}) {
            color::ColorScale scale = scale_of("plasma", {1, 100});
            scale.steps = steps;
            scale.log = log;
            draw(band(1, 100), scale);
            const auto colors = color::color_row(scale, 0);
            ASSERT_EQ(colors.size(), static_cast<std::size_t>(steps));
            std::size_t now = 0;
            for (int x = 0; x < width; ++x) {
                if (now + 1 < colors.size() && at(x) == colors[now + 1]) {
                    const double bound = color::value_at(scale, (now + 1.0) / steps);
                    EXPECT_NEAR((bound - 1) / 99 * width, x, 1) << steps << " steps, bound " << now + 1;
                    ++now;
                }
                ASSERT_EQ(at(x), colors[now]) << steps << " steps, pixel " << x << ": no color but the steps' own";
            }
            EXPECT_EQ(now + 1, colors.size());
        }
}

TEST_P(ColorScalePicture, ColorsOutsideTheRangeAreExact) {
    color::ColorScale scale = scale_of("grayscale", {-1, 1});
    scale.below = color::Rgb8{12, 34, 250};
    scale.above = color::Rgb8{251, 60, 7};
    scale.nan = {3, 200, 90};
    for (const float opacity : {1.0F, 0.999F}) { // transparent primitives keep their scales in another texture
        draw(band(-2, 2), scale, opacity);
        for (const int x : {0, 50, 98}) EXPECT_EQ(at(x), *scale.below) << x;
        for (const int x : {301, 350, 399}) EXPECT_EQ(at(x), *scale.above) << x;
        EXPECT_NEAR(at(200)[0], 128, 2);
        EXPECT_LT(at(102)[0], 8) << "the lowest inside is black";
        EXPECT_GT(at(297)[0], 247);
    }
    Shape missing = band(0, 0);
    for (float& value : missing.scalars) value = std::numeric_limits<float>::quiet_NaN();
    draw(missing, scale);
    EXPECT_EQ(at(200), scale.nan);
    for (float& value : missing.scalars) value = std::numeric_limits<float>::infinity();
    draw(missing, scale);
    EXPECT_EQ(at(200), scale.nan) << "no number either";
}

// Rounding during interpolation must not lift the largest value of the data above the range.
TEST_P(ColorScalePicture, FlatMaximumHasNoSpecks) {
    for (const float value : {1.0F, 0.1F, 273.15F, 101325.0F, -7.3e-9F, 3.3e20F}) {
        color::ColorScale scale = scale_of("grayscale", {value - std::abs(value) / 2, value});
        scale.above = color::Rgb8{255, 0, 0};
        scale.below = color::Rgb8{0, 0, 255};
        draw(band(value, value, 37), scale);
        for (int x = 0; x < width; ++x)
            for (int y = 0; y < height; y += 3)
                ASSERT_EQ(at(x, y), (color::Rgb8{255, 255, 255})) << value << ' ' << x << ' ' << y;
    }
}

// The range of 0.001 K at 300 K is only 33 float32 steps wide; all of them must stay distinguishable.
TEST_P(ColorScalePicture, NarrowRangesKeepTheirDigits) {
    const color::ColorScale scale = scale_of("grayscale", {300, 300.001F});
    draw(band(300, 300.001F), scale);
    for (const int x : {20, 100, 200, 300, 380}) EXPECT_NEAR(at(x)[0], (x + 0.5) / width * 255, 12) << x;
}

TEST_P(ColorScalePicture, PointsHaveTheirColorsAndEdges) {
    color::ColorScale scale;
    scale.points = {{0, {255, 0, 0}}, {0.3, {0, 255, 0}}, {0.3, {0, 0, 255}}, {0.8, {10, 20, 30}}};
    draw(band(0, 1), scale);
    expect_rule(scale, 0, 1, 3);
    EXPECT_GT(at(118)[1], 245);
    EXPECT_GT(at(121)[2], 245) << "two points at one place are an edge";
    EXPECT_EQ(at(390), (color::Rgb8{10, 20, 30}));
}

// Eight layers of one frame have different scales and opacities. The next frame changes all scales.
TEST_P(ColorScalePicture, EachLayerHasItsOwnScale) {
    std::vector<Shape> shapes;
    std::vector<Primitives> all;
    for (int i = 0; i < 8; ++i) {
        shapes.push_back(grid(1, 1, [&](double u, double v) {
            return Vec3f{static_cast<float>(-10 + 2.5 * (i + u)), 0, static_cast<float>(2 * v - 1)};
        }));
        shapes.back().scalars.assign(4, 5.0F);
    }
    for (int round = 0; round < 3; ++round) {
        all.clear();
        for (int i = 0; i < 8; ++i) {
            Primitives primitives = shapes[static_cast<std::size_t>(i)].primitives();
            primitives.lit = false;
            primitives.scale.map = color::color_map_names()[static_cast<std::size_t>(i + round)];
            primitives.scale.range = {0, static_cast<float>(6 + i)};
            primitives.scale.reverse = (i + round) % 2 == 0;
            primitives.scale.steps = i % 3 == 0 ? 4 : 0;
            primitives.color[3] = i % 2 == 0 ? 1.0F : 0.999F;
            all.push_back(primitives);
        }
        draw(all);
        for (int i = 0; i < 8; ++i) {
            const color::Rgb8 wanted = color::color_of(all[static_cast<std::size_t>(i)].scale, 5);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(at(50 * i + 25)[k], wanted[k], 2) << round << " layer " << i << " channel " << k;
        }
    }
}

} // namespace
} // namespace server::render
