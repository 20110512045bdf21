// Points, surfaces, lines and volumes are blended in depth order at every pixel, soft edges included. Compared with
// computed colors.
#include "backends.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>
#include <random>

namespace server::render {
using namespace ciel;
namespace {

using Color = std::array<double, 3>;
using Layers = std::vector<std::pair<Color, double>>; // colors with opacity, from the nearest on

constexpr Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1}, white{1, 1, 1}, black{};

Color over(const Layers& nearest_first, const Color& background) {
    Color sum{};
    double through = 1;
    for (const auto& [color, opacity] : nearest_first) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += through * opacity * color[k];
        through *= 1 - opacity;
    }
    for (std::size_t k = 0; k < 3; ++k) sum[k] += through * background[k];
    return sum;
}

class Points : public testing::TestWithParam<Backend> {
protected:
    Points() {
        frame.background_top = frame.background_bottom = {0, 0, 0};
        shapes.reserve(64);
    }
    Primitives& add(Shape shape, const Color& color, double opacity) {
        shapes.push_back(std::move(shape));
        Primitives primitives = shapes.back().primitives();
        primitives.scalars = {};
        primitives.normals = {};
        primitives.lit = false;
        for (std::size_t k = 0; k < 3; ++k) primitives.color[k] = static_cast<float>(color[k]);
        primitives.color[3] = static_cast<float>(opacity);
        frame.primitives.push_back(primitives);
        return frame.primitives.back();
    }
    Primitives& add_points(std::vector<Vec3f> places, const Color& color, double opacity, float size = 11) {
        Shape shape;
        for (Index i = 0; i < places.size(); ++i) shape.indices.push_back(i);
        shape.positions = std::move(places);
        Primitives& primitives = add(std::move(shape), color, opacity);
        primitives.points = true;
        primitives.point_size = size;
        return primitives;
    }
    Primitives& add_line(const Vec3f& from, const Vec3f& to, const Color& color, double opacity, float width = 6) {
        Primitives& primitives = add({{from, to}, {}, {}, {0, 1}}, color, opacity);
        primitives.lines = true;
        primitives.line_width = width;
        return primitives;
    }
    void draw() { renderer.draw(frame, image); }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
    }
    void expect(int x, int y, const Color& color, const char* what, double most = 2) const {
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(at(x, y)[k], 255 * color[k], most) << what << " at " << x << ", " << y;
    }
    // Expects `color` for every order of the primitives, at 1 and 4 samples.
    void expect_in_any_order(const Color& color, const char* what, double most = 2) {
        for (const int samples : {1, 4}) {
            frame.samples = samples;
            for (std::size_t turn = 0; turn < frame.primitives.size(); ++turn) {
                std::rotate(frame.primitives.begin(), frame.primitives.begin() + 1, frame.primitives.end());
                draw();
                expect(160, 120, color, what, most);
            }
        }
    }
    // Darkest byte of the pixels up to `reach` pixels from the middle.
    [[nodiscard]] int darkest(int reach) const {
        int least = 255;
        for (int y = 120 - reach; y < 120 + reach; ++y)
            for (int x = 160 - reach; x < 160 + reach; ++x)
                for (std::size_t k = 0; k < 3; ++k) least = std::min<int>(least, at(x, y)[k]);
        return least;
    }
    void add_scatter(const Color& color, double opacity, unsigned seed, float size) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> place(-0.7F, 0.7F);
        std::vector<Vec3f> places(60);
        for (Vec3f& at : places) at = {place(random), place(random), place(random)};
        add_points(std::move(places), color, opacity, size);
    }

    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;
    std::vector<Shape> shapes;
};

INSTANTIATE_TEST_SUITE_P(Backends, Points, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Points);

TEST_P(Points, AreMixedWithAnOpaqueSheet) {
    add_points({{0, -0.2F, 0}}, red, 0.5);
    add(square(0), white, 1);
    expect_in_any_order(over({{red, 0.5}}, white), "over it");
    shapes[0].positions[0][1] = 0.2F;
    expect_in_any_order(white, "behind it");
    shapes[0].positions[0][1] = 0;
    expect_in_any_order(over({{red, 0.5}}, white), "on it");
}

TEST_P(Points, AreMixedWithTransparentSheets) {
    for (const double opacity : {0.5, 1.0}) {
        frame.primitives.clear();
        add_points({{0, 0, 0}}, red, opacity);
        add(square(-0.3), green, 0.4);
        expect_in_any_order(over({{green, 0.4}, {red, opacity}}, black), "under one");
        add(square(0.3), blue, 0.6);
        expect_in_any_order(over({{green, 0.4}, {red, opacity}, {blue, 0.6}}, black), "between two");
        add_points({{0, 0.5F, 0}}, white, 0.5, 15);
        expect_in_any_order(over({{green, 0.4}, {red, opacity}, {blue, 0.6}, {white, 0.5}}, black), "on both sides");
    }
}

TEST_P(Points, AreMixedWithLines) {
    for (const double opacity : {0.5, 1.0})
        for (const double of_line : {0.5, 1.0}) {
            frame.primitives.clear();
            add_points({{0, 0, 0}}, red, opacity);
            add_line({-1, -0.2F, 0}, {1, -0.2F, 0}, green, of_line);
            expect_in_any_order(over({{green, of_line}, {red, opacity}}, black), "under a line");
            frame.primitives.pop_back();
            add_line({-1, 0.2F, 0}, {1, 0.2F, 0}, green, of_line);
            expect_in_any_order(over({{red, opacity}, {green, of_line}}, black), "over a line");
            frame.primitives.pop_back();
            add_line({-1, 0, 0}, {1, 0, 0}, green, of_line);
            expect_in_any_order(over({{red, opacity}, {green, of_line}}, black), "at a line's end");
        }
}

// All 50 points count, at equal or different depths, though only 32 layers are peeled.
TEST_P(Points, OfOneLayerAreSeenThroughEachOther) {
    std::vector<Vec3f> places(50, {0, 0.3F, 0});
    for (std::size_t i = 25; i < places.size(); ++i) places[i][1] = 0.01F * static_cast<float>(i);
    add_points(places, white, 0.04);
    const double through = std::pow(1 - 0.04, 50);
    expect_in_any_order({1 - through, 1 - through, 1 - through}, "fifty", 3);
    EXPECT_TRUE(renderer.remarks().empty());
}

TEST_P(Points, OfManyLayersAreMixedInTheirOrder) {
    Layers expected;
    for (int i = 0; i < 40; ++i) {
        const Color color = i % 3 == 0 ? red : i % 3 == 1 ? green : blue;
        expected.emplace_back(color, 0.1);
    }
    for (int i = 0; i < 40; ++i) {
        const int place = i * 7 % 40;
        add_points({{0, -0.9F + 0.04F * static_cast<float>(place), 0}}, expected[static_cast<std::size_t>(place)].first,
                   0.1);
    }
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        draw();
        expect(160, 120, over(expected, black), "forty layers", 3);
    }
}

// Discs of several opacities, lines and a sheet. Reversing the primitives does not change the picture.
TEST_P(Points, TheOrderOfTheDocumentDoesNotShow) {
    for (const bool with_sheet : {false, true})
        for (const bool with_half : {false, true}) {
            frame.primitives.clear();
            add_scatter(red, 1, 1, 13);
            add_scatter(green, 1, 2, 9);
            add_line({-0.9F, -0.9F, -0.6F}, {0.9F, 0.9F, 0.4F}, white, 1, 3);
            if (with_half) add_scatter(blue, 0.5, 3, 13);
            if (with_half) add_scatter(white, 0.7, 4, 9);
            if (with_sheet) add(square(0), white, 0.5);
            for (const int samples : {1, 4}) {
                frame.samples = samples;
                draw();
                const Image first = image;
                std::ranges::reverse(frame.primitives);
                for (Shape& shape : shapes) std::ranges::reverse(shape.indices);
                draw();
                int worst = 0;
                for (std::size_t i = 0; i < image.rgb.size(); ++i)
                    worst = std::max(worst, std::abs(image.rgb[i] - first.rgb[i]));
                EXPECT_LE(worst, 2) << samples << " samples, a sheet: " << with_sheet << ", half: " << with_half;
            }
        }
}

// Everything is white except the background, so no pixel may be darker than the sheet alone.
TEST_P(Points, NoPixelIsDarkerThanWhatItIsMixedFrom) {
    for (const double sheet : {0.5, 0.9, 1.0})
        for (const double opacity : {0.5, 1.0})
            for (const int samples : {1, 4}) {
                frame.primitives.clear();
                frame.samples = samples;
                add(square(0), white, sheet);
                draw();
                const int alone = darkest(60);
                add_scatter(white, opacity, 5, 13);
                add_scatter(white, 1, 6, 4);
                add_line({-0.9F, -0.5F, -0.6F}, {0.9F, 0.5F, 0.4F}, white, opacity, 3);
                draw();
                EXPECT_GE(darkest(60), alone - 2)
                    << "a sheet of " << sheet << ", opacity " << opacity << ", " << samples << " samples";
            }
}

// The soft edge of a nearer point shows the farther point under it, not the background behind both.
TEST_P(Points, EdgesOverPointsAndLinesAreNoHoles) {
    for (const bool near_first : {true, false})
        for (const int samples : {1, 4}) {
            frame.primitives.clear();
            frame.samples = samples;
            add_points({{0, -0.2F, 0}, {0.06F, 0, 0.03F}}, white, 1, 12);
            add_points({{0, 0.2F, 0}}, white, 1, 60);
            if (!near_first) std::swap(frame.primitives[0], frame.primitives[1]);
            draw();
            EXPECT_GE(darkest(19), 253) << samples << " samples";
            frame.primitives.pop_back();
            frame.primitives.pop_back();
            add_points({{0, -0.2F, 0}}, white, 1, 12);
            add_line({-1, 0.2F, 0}, {1, 0.2F, 0}, white, 1, 8);
            if (!near_first) std::swap(frame.primitives[0], frame.primitives[1]);
            draw();
            for (int x = 100; x < 220; ++x) EXPECT_GE(at(x, 120)[0], 253) << samples << " samples, at " << x;
        }
}

TEST_P(Points, HaveSmoothEdgesInAStill) {
    for (const double opacity : {0.5, 1.0}) {
        frame.primitives.clear();
        frame.samples = 4;
        add_points({{0.003F, 0, 0.002F}}, white, opacity, 40);
        draw();
        int between = 0;
        double sum = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            const double share = image.rgb[i] / (255 * opacity);
            between += share > 0.1 && share < 0.9 ? 1 : 0;
            sum += share;
        }
        EXPECT_GT(between, 80);
        EXPECT_NEAR(sum, std::numbers::pi * 400, 8) << "pixels";
    }
}

// The point is in the middle of the fog, so half of the fog is in front of it.
TEST_P(Points, InAVolumeAreSeenThroughWhatIsInFront) {
    VolumeScene fog(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    Volume volume = fog.volume({0, 1, 0}, 50);
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0.5}, {1, 0.5}};
    volume.unit_length = 2;
    frame.volumes = {volume};
    frame.bounds_min = {0, 0, 0};
    frame.bounds_max = {4, 4, 4};
    frame.camera.position = {2, -9, 2};
    frame.camera.target = {2, 2, 2};
    frame.camera.parallel_height = 6;
    for (const double opacity : {0.5, 1.0}) {
        frame.primitives.clear();
        add_points({{2, 2, 2}}, red, opacity, 15);
        expect_in_any_order(over({{white, 0.5}, {red, opacity}, {white, 0.5}}, black), "in it", 4);
        add_points({{2, 3, 2}}, green, 0.5, 9);
        const double quarter = 1 - std::sqrt(0.5);
        expect_in_any_order(
            over({{white, 0.5}, {red, opacity}, {white, quarter}, {green, 0.5}, {white, quarter}}, black), "two", 4);
        frame.primitives.pop_back();
        add(grid(1, 1,
                 [](double u, double v) {
                     return Vec3f{static_cast<float>(4 * u), 3, static_cast<float>(4 * v)};
                 }),
            blue, 0.5);
        expect_in_any_order(
            over({{white, 0.5}, {red, opacity}, {white, quarter}, {blue, 0.5}, {white, quarter}}, black),
            "before a sheet", 4);
        shapes.back() = grid(1, 1, [](double u, double v) {
            return Vec3f{static_cast<float>(4 * u), 1, static_cast<float>(4 * v)};
        });
        frame.primitives.back().positions = shapes.back().positions;
        frame.primitives.back().indices = shapes.back().indices;
        expect_in_any_order(
            over({{white, quarter}, {blue, 0.5}, {white, quarter}, {red, opacity}, {white, 0.5}}, black),
            "behind a sheet", 4);
    }
}

TEST_P(Points, AreCutByPlanesAndFoundByAPointer) {
    for (const double opacity : {0.5, 1.0})
        for (const int samples : {1, 4}) {
            frame.primitives.clear();
            frame.clip.clear();
            frame.samples = samples;
            add_points({{0, 0.25F, 0}, {0.5F, 0.25F, 0}}, white, opacity);
            frame.clip = {{-1, 0, 0, 0.3F}};
            draw();
            Vec3d found{};
            ASSERT_TRUE(renderer.pick(160, 120, found));
            EXPECT_NEAR(found[1], 0.25, 1e-3);
            EXPECT_FALSE(renderer.pick(200, 120, found)) << "cut away";
            expect(160, 120, over({{white, opacity}}, black), "kept");
            expect(200, 120, black, "cut away");
        }
}

} // namespace
} // namespace server::render
