// Depth peeling against computed colors: transparent layers are blended in depth order at every pixel, also with
// volumes.
#include "backends.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

using Color = std::array<double, 3>;

// Blends layers of (color, opacity), given from the nearest on, over the background.
Color over(const std::vector<std::pair<Color, double>>& nearest_first, const Color& background) {
    Color sum{};
    double through = 1;
    for (const auto& [color, opacity] : nearest_first) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += through * opacity * color[k];
        through *= 1 - opacity;
    }
    for (std::size_t k = 0; k < 3; ++k) sum[k] += through * background[k];
    return sum;
}

class PeelingTest : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;
    std::vector<Shape> shapes;

    PeelingTest() {
        frame.samples = 4;
        frame.background_top = frame.background_bottom = {0, 0, 0};
        shapes.reserve(64);
    }
    void add(Shape shape, const Color& color, double opacity) {
        shapes.push_back(std::move(shape));
        Primitives primitives = shapes.back().primitives();
        primitives.scalars = {};
        primitives.lit = false;
        for (std::size_t k = 0; k < 3; ++k) primitives.color[k] = static_cast<float>(color[k]);
        primitives.color[3] = static_cast<float>(opacity);
        frame.primitives.push_back(primitives);
    }
    void expect(int x, int y, const Color& color, double most = 2) const {
        const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(p[k], 255 * color[k], most) << "at " << x << ", " << y;
    }
};

// Two squares of two triangles each cross in the middle. One is nearer on the left, the other on the right.
TEST_P(PeelingTest, SurfacesThatCross) {
    const auto leaning = [](float lean) {
        return grid(1, 1, [&](double u, double v) {
            return Vec3f{static_cast<float>(2 * u - 1), lean * static_cast<float>(2 * u - 1),
                         static_cast<float>(2 * v - 1)};
        });
    };
    const Color red{1, 0, 0}, blue{0, 0, 1};
    add(leaning(0.5F), red, 0.5); // nearer on the left, where y is smaller
    add(leaning(-0.5F), blue, 0.5);
    renderer.draw(frame, image);
    expect(100, 120, over({{red, 0.5}, {blue, 0.5}}, {}));
    expect(220, 120, over({{blue, 0.5}, {red, 0.5}}, {}));
    expect(5, 5, {});
}

TEST_P(PeelingTest, ManyLayersInAnyOrder) {
    std::vector<std::pair<Color, double>> expected;
    for (int i = 0; i < 20; ++i)
        expected.push_back({{i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0}, 0.1 + 0.01 * i});
    for (int i = 0; i < 20; ++i) {
        const int place = i * 7 % 20;
        add(square(-0.9 + 0.09 * place), expected[static_cast<std::size_t>(place)].first,
            expected[static_cast<std::size_t>(place)].second);
    }
    renderer.draw(frame, image);
    expect(160, 120, over(expected, {}));
}

TEST_P(PeelingTest, OpaqueSurfacesHideWhatIsBehind) {
    const Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
    add(square(-0.5), red, 0.5);
    add(square(0), green, 1);
    add(square(0.5), blue, 0.5);
    renderer.draw(frame, image);
    expect(160, 120, over({{red, 0.5}}, green));
}

// An opaque sliver less than a pixel high in front of a sheet. Uneven coverage would make it a dashed line.
TEST_P(PeelingTest, AnOpaqueSliverInFrontOfASheetIsNoLineOfDashes) {
    add(square(0.5), {1, 1, 1}, 0.5);
    const double pixel = frame.camera.parallel_height / frame.height;
    add(grid(1, 1,
             [&](double u, double v) {
                 return Vec3f{static_cast<float>(2 * u - 1), 0, static_cast<float>((4 * u + 0.7 * v) * pixel)};
             }),
        {0, 0, 0}, 1);
    renderer.draw(frame, image);
    for (int x = 90; x < 230; ++x) {
        const auto red_at = [&](int y) {
            return static_cast<double>(image.rgb[3 * static_cast<std::size_t>(y * image.width + x)]);
        };
        const double of_sheet = red_at(60); // 127 or 128: GPUs round 127.5 in different ways
        EXPECT_NEAR(of_sheet, 127.5, 0.5);
        double missing = 0;
        for (int y = 100; y < 130; ++y) missing += 1 - red_at(y) / of_sheet;
        EXPECT_GT(missing, 0.3) << "at " << x;
        EXPECT_LT(missing, 1.1) << "at " << x;
    }
}

// A small sphere inside a large one: four layers in the middle, two where only the large sphere is.
TEST_P(PeelingTest, SurfacesThatEncloseEachOther) {
    const Color red{1, 0, 0}, green{0, 1, 0};
    add(sphere(0.9), red, 0.3);
    add(sphere(0.4), green, 0.6);
    renderer.draw(frame, image);
    expect(160, 120, over({{red, 0.3}, {green, 0.6}, {green, 0.6}, {red, 0.3}}, {}));
    expect(160 + 48, 120, over({{red, 0.3}, {red, 0.3}}, {}));
}

TEST_P(PeelingTest, EdgesAreSmooth) {
    add(sphere(0.9), {1, 1, 1}, 0.5);
    renderer.draw(frame, image);
    std::size_t between = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        if (image.rgb[i] > 20 && image.rgb[i] < 170) ++between;
    EXPECT_GT(between, 200U) << "pixels along the outline that are partly covered";
}

// The nearest 32 layers are drawn (depth_peeling.cpp). Layers beyond are dropped as if absent, with a remark.
TEST_P(PeelingTest, ThirtyTwoLayersAreSeen) {
    std::vector<std::pair<Color, double>> expected;
    for (int i = 39; i >= 0; --i) {
        const Color color = i == 31 ? Color{1, 0, 0} : i == 32 ? Color{0, 1, 0} : Color{0, 0, 1};
        add(square(-0.9 + 0.045 * i), color, i == 31 || i == 32 ? 0.9 : 0.02);
        if (i < 32) expected.insert(expected.begin(), {color, i == 31 ? 0.9 : 0.02});
    }
    renderer.draw(frame, image);
    expect(160, 120, over(expected, {}));
    ASSERT_EQ(renderer.remarks().size(), 1U);
    EXPECT_NE(renderer.remarks()[0].find("more than 32 transparent surfaces"), std::string::npos);
}

TEST_P(PeelingTest, NothingIsSaidOfLayersThatWouldNotBeSeen) {
    frame.width = 80;
    frame.height = 60;
    for (int i = 0; i < 32; ++i) add(square(-0.9 + 0.045 * i), {0, 0, 1}, 0.02);
    renderer.draw(frame, image);
    EXPECT_TRUE(renderer.remarks().empty()) << "as many as there may be";
    for (int i = 32; i < 40; ++i) add(square(-0.9 + 0.045 * i), {0, 0, 1}, 0.02);
    for (Primitives& primitives : frame.primitives) primitives.color[3] = 0.3F;
    renderer.draw(frame, image);
    EXPECT_TRUE(renderer.remarks().empty()) << "the first eighteen let nothing through";
}

TEST_P(PeelingTest, MoreThanEightLayersAreSeenInAVolume) {
    VolumeScene air(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    Volume volume = air.volume({0, 1, 0}, 20);
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0}, {1, 0}};
    frame.volumes = {volume};
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {4, 4, 4};
    std::vector<std::pair<Color, double>> expected;
    for (int i = 11; i >= 0; --i) {
        const Color color = i == 7 ? Color{1, 0, 0} : i == 8 ? Color{0, 1, 0} : Color{0, 0, 1};
        const double opacity = i == 7 || i == 8 ? 0.8 : 0.1;
        add(square(-0.9 + 0.1 * i), color, opacity);
        expected.insert(expected.begin(), {color, opacity});
    }
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        renderer.draw(frame, image);
        expect(160, 120, over(expected, {}));
    }
}

// Layers beyond the eighth are drawn with slightly too little fog in front of them, so the tolerance is larger.
TEST_P(PeelingTest, TwentyLayersInFogAreSeenThroughIt) {
    VolumeScene fog(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    Volume volume = fog.volume({0, 1, 0}, 60);
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0.5}, {1, 0.5}};
    volume.unit_length = 4;
    frame.volumes = {volume};
    frame.bounds_min = {0, 0, 0};
    frame.bounds_max = {4, 4, 4};
    frame.camera.position = {2, -9, 2};
    frame.camera.target = {2, 2, 2};
    frame.camera.parallel_height = 6;
    constexpr int count = 20;
    const double fog_between = 1 - std::pow(0.5, 1.0 / (count + 1));
    std::vector<std::pair<Color, double>> expected{{{1, 1, 1}, fog_between}};
    for (int i = 0; i < count; ++i) {
        const Color color = i % 2 == 0 ? Color{1, 0, 0} : Color{0, 0, 1};
        add(grid(1, 1,
                 [&](double u, double v) {
                     return Vec3f{static_cast<float>(4 * u), 4 * static_cast<float>(i + 1) / (count + 1),
                                  static_cast<float>(4 * v)};
                 }),
            color, 0.06);
        expected.insert(expected.end(), {{color, 0.06}, {{1, 1, 1}, fog_between}});
    }
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        renderer.draw(frame, image);
        expect(160, 120, over(expected, {}), 4);
    }
}

TEST_P(PeelingTest, AClipPlaneCutsLayers) {
    const Color red{1, 0, 0}, blue{0, 0, 1};
    add(square(-0.5), red, 0.5);
    add(square(0.5), blue, 0.5);
    frame.clip = {{1, 0, 0, 0}};
    renderer.draw(frame, image);
    expect(220, 120, over({{red, 0.5}, {blue, 0.5}}, {}));
    expect(100, 120, {});
}

// The sheet rises towards the viewer across the line's width, so it would cover half of the line without an offset.
TEST_P(PeelingTest, LinesOnASheetAreNotBuried) {
    add(grid(1, 1,
             [](double u, double v) {
                 return Vec3f{static_cast<float>(2 * u - 1), static_cast<float>(1.8 * u - 0.9),
                              static_cast<float>(2 * v - 1)};
             }),
        {1, 0, 0}, 0.5);
    Shape line;
    line.positions = {{0, 0, -1}, {0, 0, 1}};
    line.indices = {0, 1};
    add(line, {0, 1, 0}, 1);
    frame.primitives.back().lines = true;
    frame.primitives.back().line_width = 8;
    renderer.draw(frame, image);
    for (int x = 157; x < 163; ++x) expect(x, 120, {0, 1, 0});
}

// A line's soft edge must show the sheet under it, not what is behind the sheet: red and green add up at each pixel.
TEST_P(PeelingTest, LinesOnASheetHaveNoHoleAroundThem) {
    const Color red{1, 0, 0}, green{0, 1, 0}, blue{0, 0, 1};
    const auto leaning = grid(1, 1, [](double u, double v) {
        return Vec3f{static_cast<float>(2 * u - 1), static_cast<float>(1.5 * u - 0.75), static_cast<float>(2 * v - 1)};
    });
    add(leaning, red, 0.5);
    add(leaning, green, 1);
    shapes.back().indices = {0, 3};
    frame.primitives.back().indices = shapes.back().indices;
    frame.primitives.back().lines = true;
    for (const bool sheet_in_front : {false, true}) {
        if (sheet_in_front) add(square(-0.9), blue, 0.5);
        renderer.draw(frame, image);
        const double most = sheet_in_front ? 0.5 : 1; // share of the light that passes the front sheet
        std::size_t partly = 0;
        for (int y = 90; y < 150; ++y)
            for (int x = 130; x < 190; ++x) {
                const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
                EXPECT_NEAR(p[0] / (255 * 0.5 * most) + p[1] / (255 * most), 1, 0.04) << "at " << x << ", " << y;
                if (p[1] > 20 * most && p[1] < 235 * most) ++partly;
            }
        EXPECT_GT(partly, 60U) << "pixels of soft edges";
    }
}

// While something moves, triangles are sorted and drawn after the lines. The line must have no gaps and no dark edge
// pixels. Behind the sheet it is half as bright.
TEST_P(PeelingTest, LinesOnASheetAreWholeWhileSomethingMoves) {
    add(square(0), {1, 0, 0}, 0.5);
    for (const float depth : {-0.1F, 0.1F})
        for (const bool points : {false, true}) {
            const std::vector<Vec3f> ends{{-0.8F, depth, -0.23F}, {0.8F, depth, 0.31F}};
            frame.primitives.resize(1);
            frame.primitives.push_back(line_between(ends, 1.5F, {0, 1, 0, 1}));
            frame.primitives[1].lines = !points;
            frame.primitives[1].points = points;
            frame.primitives[1].lit = false;
            frame.samples = 1;
            frame.camera.position = {0.3, -5, 0.2};
            renderer.draw(frame, image);
            const double most = depth < 0 ? 1 : 0.5; // brightness of the line
            int seen = 0;
            for (int x = 0; x < image.width; ++x) {
                double brightest = 0;
                for (int y = 0; y < image.height; ++y) {
                    const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
                    if (p[1] < 5) continue;
                    EXPECT_GE(p[0] / 127.5 + p[1] / 255.0, 0.98) << "a hole at " << x << ", " << y;
                    brightest = std::max(brightest, p[1] / 255.0);
                }
                if (brightest == 0) continue;
                ++seen;
                if (!points) {
                    EXPECT_NEAR(brightest, most, 0.02) << "a gap at " << x;
                }
            }
            EXPECT_GT(seen, points ? 5 : 100);
        }
}

// A cube of constant fog with a sheet in its middle: half of the fog is in front of the sheet. Tested with slabs along
// the view, and across it with four thick slabs.
TEST_P(PeelingTest, ASheetInAVolume) {
    VolumeScene along(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    VolumeScene across(test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; });
    frame.bounds_min = {0, 0, 0};
    frame.bounds_max = {4, 4, 4};
    frame.camera.position = {2, -9, 2};
    frame.camera.target = {2, 2, 2};
    frame.camera.parallel_height = 6;
    const Color red{1, 0, 0}, green{0, 1, 0}, white{1, 1, 1};
    const auto sheet = [](double y) {
        return grid(1, 1, [&](double u, double v) {
            return Vec3f{static_cast<float>(4 * u), static_cast<float>(y), static_cast<float>(4 * v)};
        });
    };
    // A length of 2 takes half of the light.
    const auto fog = [](double length) { return 1 - std::pow(0.5, length / 2); };
    for (Volume volume : {along.volume({1, 0, 0}, 50), across.volume({0, 1, 0}, 4)})
        for (const bool parallel : {true, false})
            for (const int samples : {1, 4}) {
                volume.scale.range = {0, 1};
                volume.opacity_points = {{0, 0.5}, {1, 0.5}};
                volume.unit_length = 2;
                frame.camera.parallel = parallel;
                frame.samples = samples;
                frame.primitives.clear();
                frame.volumes = {volume};
                add(sheet(2.2), red, 0.5);
                renderer.draw(frame, image);
                expect(160, 120, over({{white, fog(2.2)}, {red, 0.5}, {white, fog(1.8)}}, {}), 3);
                add(sheet(3.4), green, 1);
                renderer.draw(frame, image);
                expect(160, 120, over({{white, fog(2.2)}, {red, 0.5}, {white, fog(1.2)}}, green), 3);
            }
}

INSTANTIATE_TEST_SUITE_P(, PeelingTest, testing::ValuesIn(available_backends()), name_of_test);

} // namespace
} // namespace server::render
