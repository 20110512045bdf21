// Pictures of shapes with a known appearance, on every back end of this machine. Failing pictures stay in the build
// folder.
#include "annotations/camera.hpp"
#include "backends.hpp"
#include "color/color_map.hpp"
#include "scenes.hpp"
#include "wire/pictures/png.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace server::render {
using namespace ciel;
namespace {

struct Pixel {
    int r, g, b;
    [[nodiscard]] int brightness() const { return (r + g + b) / 3; }
};

class RendererTest : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;

    void draw() { renderer.draw(frame, image); }
    [[nodiscard]] Pixel at(int x, int y) const {
        const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] Pixel center() const { return at(image.width / 2, image.height / 2); }
    template <typename Predicate>
    [[nodiscard]] double share(Predicate predicate) const {
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) count += predicate(at(x, y)) ? 1 : 0;
        return static_cast<double>(count) / (image.width * image.height);
    }
    void TearDown() override {
        if (image.rgb.empty() || (!HasFailure() && std::getenv("CIEL_KEEP_PICTURES") == nullptr)) return;
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = test->name();
        for (char& c : name)
            if (c == '/') c = '_';
        const auto folder = std::filesystem::path(CIEL_BINARY_DIR) / "pictures";
        std::filesystem::create_directories(folder);
        std::vector<std::uint8_t> png;
        wire::encode_png(image.width, image.height, image.rgb, png);
        std::ofstream(folder / (name + ".png"), std::ios::binary)
            .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, RendererTest, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RendererTest);

TEST_P(RendererTest, BackgroundRunsFromTopToBottom) {
    frame.background_top = {1, 0, 0};
    frame.background_bottom = {0, 0, 1};
    draw();
    EXPECT_GT(at(10, 0).r, 250);
    EXPECT_LT(at(10, 0).b, 5);
    EXPECT_GT(at(10, 239).b, 250);
    EXPECT_NEAR(center().r, 128, 2);
}

TEST_P(RendererTest, SphereIsLitAndHasNoBlackPatches) {
    frame.width = 640;
    frame.height = 480;
    frame.samples = 4;
    const Shape shape = sphere(1);
    for (const bool smooth : {true, false}) {
        for (const bool inverted : {false, true}) {
            Primitives primitives = shape.primitives();
            std::vector<Vec3f> normals = shape.normals;
            if (inverted)
                for (Vec3f& n : normals) n = {-n[0], -n[1], -n[2]};
            primitives.normals = smooth ? std::span<const Vec3f>(normals) : std::span<const Vec3f>();
            frame.primitives = {primitives};
            draw();
            // The ball is a disc of radius 1 in a view of 3 x 4 units.
            const double covered = share([](Pixel p) { return p.brightness() > 42; });
            EXPECT_NEAR(covered, std::numbers::pi / 12, 0.004) << smooth << inverted;
            // Within nine tenths of the radius no pixel is dark.
            int darkest = 255;
            for (int y = 0; y < 480; ++y)
                for (int x = 0; x < 640; ++x)
                    if (std::hypot(x + 0.5 - 320, y + 0.5 - 240) < 0.9 * 160)
                        darkest = std::min(darkest, at(x, y).brightness());
            EXPECT_GT(darkest, 75) << smooth << inverted;
            EXPECT_GT(at(270, 180).brightness(), at(375, 300).brightness() + 25)
                << "the key light is at the upper left";
            EXPECT_GT(center().brightness(), 170);
        }
    }
}

// Each pixel has the color that the map gives its x coordinate. The picture is 4 units wide.
TEST_P(RendererTest, UnlitSliceShowsTheColorMapExactly) {
    const Shape shape = square(0);
    for (const std::string& name : color::color_map_names()) {
        Primitives primitives = shape.primitives();
        primitives.scale.map = name;
        primitives.scale.range = {-1, 1};
        primitives.lit = false;
        frame.primitives = {primitives};
        draw();
        for (const int x : {85, 120, 160, 200, 235}) {
            const double value = ((x + 0.5) / 320 * 4 - 2) / 2 + 0.5;
            const auto& expected = color::color_map(name)[static_cast<std::size_t>(std::lround(value * 255))];
            const Pixel seen = at(x, 120);
            EXPECT_NEAR(seen.r, expected[0], 4) << name << ' ' << x;
            EXPECT_NEAR(seen.g, expected[1], 4) << name << ' ' << x;
            EXPECT_NEAR(seen.b, expected[2], 4) << name << ' ' << x;
        }
    }
}

TEST_P(RendererTest, ValuesOutsideTheRangeTakeItsEndsAndNaNIsGrey) {
    Shape shape = square(0);
    for (std::size_t i = 0; i < shape.scalars.size(); ++i)
        if (shape.positions[i][2] > 0.5F) shape.scalars[i] = std::numeric_limits<float>::quiet_NaN();
    Primitives primitives = shape.primitives();
    primitives.lit = false;
    primitives.scale.range = {-0.25F, 0.25F};
    frame.primitives = {primitives};
    draw();
    const std::string map = "viridis";
    const auto& viridis = color::color_map(map);
    EXPECT_NEAR(at(90, 120).b, viridis[0][2], 2);
    EXPECT_NEAR(at(230, 120).g, viridis[255][1], 2);
    const Pixel grey = at(160, 60);
    EXPECT_NEAR(grey.r, 128, 2);
    EXPECT_NEAR(grey.g, 128, 2);
    EXPECT_NEAR(grey.b, 128, 2);
    primitives.scale.range = {0, 0}; // range of a constant field, which has the color in the middle of the map
    frame.primitives = {primitives};
    draw();
    EXPECT_NEAR(center().g, viridis[128][1], 3);
}

TEST_P(RendererTest, LinesHaveTheirWidthAndHideBehindSurfaces) {
    const std::vector<Vec3f> ends{{-1.5F, 0, 0}, {1.5F, 0, 0}};
    const Primitives lines = line_between(ends, 8, {1, 1, 0, 1});
    frame.primitives = {lines};
    draw();
    int lit = 0;
    for (int y = 0; y < 240; ++y) lit += at(160, y).r > 128 ? 1 : 0;
    EXPECT_NEAR(lit, 8, 1);
    EXPECT_LT(at(20, 120).r, 60) << "the line ends";

    const Shape shape = square(-0.5); // the square is in front of the line
    Primitives surface = shape.primitives();
    surface.scalars = {};
    surface.color = {0, 0, 1, 1};
    frame.primitives = {lines, surface};
    draw();
    EXPECT_LT(center().r, 60);
    EXPECT_GT(at(60, 120).r, 200) << "beside the surface the line is still seen";
}

TEST_P(RendererTest, LinesThroughTheEyeAreCutAtTheNearestPlane) {
    frame.camera.parallel = false;
    frame.camera.position = {0, 0, 0};
    frame.camera.target = {0, 1, 0};
    const std::vector<Vec3f> ends{{0.2F, -1, 0}, {0.2F, 1, 0}};
    frame.primitives = {line_between(ends, 4, {1, 1, 0, 1})};
    draw();
    EXPECT_GT(at(300, 120).r, 200);
    EXPECT_LT(at(20, 120).r, 60) << "what is behind the eye must not appear on the other side";
}

// A red square behind a green one, both half transparent. The order of the primitives has no effect.
TEST_P(RendererTest, TransparentSurfacesBlendFromTheBackToTheFront) {
    const Shape near_shape = square(-0.5);
    const Shape far_shape = square(0.5);
    Primitives near_mesh = near_shape.primitives();
    Primitives far_mesh = far_shape.primitives();
    near_mesh.scalars = far_mesh.scalars = {};
    near_mesh.lit = far_mesh.lit = false;
    near_mesh.color = {0, 1, 0, 0.5F};
    far_mesh.color = {1, 0, 0, 0.5F};
    frame.background_top = frame.background_bottom = {0, 0, 0};
    for (const bool near_first : {false, true}) {
        frame.primitives = near_first ? std::vector{near_mesh, far_mesh} : std::vector{far_mesh, near_mesh};
        draw();
        EXPECT_NEAR(center().g, 128, 2);
        EXPECT_NEAR(center().r, 64, 2);
    }
    near_mesh.color[3] = 0;
    frame.primitives = {near_mesh};
    draw();
    EXPECT_EQ(center().brightness(), 0);
}

TEST_P(RendererTest, TransparentSurfaceIsHiddenByAnOpaqueOne) {
    const Shape ball = sphere(0.5);
    const Shape behind = square(0.9);
    Primitives opaque = ball.primitives();
    opaque.color = {0, 0, 1, 1};
    Primitives transparent = behind.primitives();
    transparent.scalars = {};
    transparent.color = {1, 0, 0, 0.5F};
    frame.primitives = {transparent, opaque};
    draw();
    EXPECT_LT(center().r, 80) << "only the highlight has red";
    EXPECT_GT(center().b, 150);
    EXPECT_GT(at(90, 120).r, 60);
}

TEST_P(RendererTest, PickFindsTheNearestSurfaceEvenATransparentOne) {
    frame.camera.parallel = false;
    frame.origin = {500000, 4000000, 100}; // large coordinates, where float32 is too coarse without `origin`
    frame.camera.position = {500000.3, 3999994, 100.2};
    frame.camera.target = {500000, 4000000, 100};
    frame.bounds_min = {499999, 3999999, 99};
    frame.bounds_max = {500001, 4000001, 101};
    const Shape ball = sphere(1, {}, 256);
    for (const int samples : {1, 4})
        for (const float opacity : {1.0F, 0.4F}) {
            frame.samples = samples;
            Primitives primitives = ball.primitives();
            primitives.color[3] = opacity;
            frame.primitives = {primitives};
            draw();
            Vec3d found{};
            EXPECT_FALSE(renderer.pick(2, 2, found));
            EXPECT_FALSE(renderer.pick(-1, 500, found));
            ASSERT_TRUE(renderer.pick(150, 110, found));
            const double x = found[0] - 500000;
            const double y = found[1] - 4000000;
            const double z = found[2] - 100;
            EXPECT_NEAR(std::hypot(x, y, z), 1, 0.003);
            EXPECT_LT(y, 0) << "the side that is seen";
        }
}

TEST_P(RendererTest, LostContextIsRebuiltByTheNextDraw) {
    const Shape shape = sphere(1);
    frame.primitives = {shape.primitives()};
    draw();
    const Image before = image;
    renderer.simulate_context_loss();
    Vec3d position{};
    EXPECT_FALSE(renderer.pick(160, 120, position));
    draw();
    EXPECT_EQ(before.rgb, image.rgb);
    EXPECT_TRUE(renderer.pick(160, 120, position));
    EXPECT_EQ(renderer.backend(), GetParam());
}

TEST_P(RendererTest, BadFramesAreRefusedAndTheNextIsDrawn) {
    const Shape shape = sphere(1);
    const std::vector<Index> beyond{0, 1, 1000000};
    struct Row {
        const char* name;
        std::function<void(Frame&)> spoil;
        const char* error;
    };
    const std::vector<Row> rows{
        {"no pixels", [](Frame& f) { f.width = 0; }, "cannot be drawn"},
        {"too large", [](Frame& f) { f.height = 1 << 20; }, "cannot be drawn"},
        {"index beyond", [&](Frame& f) { f.primitives[0].indices = beyond; }, "do not match"},
        {"half a triangle", [](Frame& f) { f.primitives[0].indices = f.primitives[0].indices.first(4); },
         "do not match"},
        {"normals missing", [](Frame& f) { f.primitives[0].normals = f.primitives[0].normals.first(3); },
         "do not match"},
        {"unknown map",
         [&](Frame& f) {
             f.primitives[0].scalars = std::span(&shape.positions[0][0], shape.positions.size());
             f.primitives[0].scale.map = "rainbow";
         },
         "no color map 'rainbow'"},
        {"camera NaN", [](Frame& f) { f.camera.position[1] = std::nan(""); }, "camera"},
        {"no field of view", [](Frame& f) { f.camera.fov_degrees = 0; }, "camera"},
        {"flat parallel view", [](Frame& f) { f.camera.parallel_height = -1; }, "camera"},
    };
    frame.primitives = {shape.primitives()};
    draw();
    const Image good = image;
    for (const Row& row : rows) {
        for (const float opacity : {1.0F, 0.5F}) {
            Frame bad = frame;
            bad.primitives[0].color[3] = opacity;
            row.spoil(bad);
            try {
                renderer.draw(bad, image);
                ADD_FAILURE() << row.name << " was drawn";
            } catch (const Error& error) {
                EXPECT_THAT(error.what(), testing::HasSubstr(row.error)) << row.name;
            }
        }
        draw();
        EXPECT_EQ(good.rgb, image.rgb) << row.name;
    }
}

TEST_P(RendererTest, DegenerateCamerasAndBoundsStillGiveAPicture) {
    const Shape shape = sphere(1);
    frame.primitives = {shape.primitives()};
    draw();
    const Image usual = image;
    EXPECT_GT(center().brightness(), 100);
    frame.camera.target = frame.camera.position; // falls back to looking along y, like the usual camera here
    draw();
    EXPECT_EQ(image.rgb, usual.rgb);
    frame.camera.target = {0, 0, 0};
    frame.camera.up = {0, 1, 0}; // parallel to the viewing direction
    draw();
    EXPECT_EQ(image.rgb, usual.rgb);
    // Empty bounds: the depth range is only a margin around the sphere's nearest point.
    frame.bounds_max = frame.bounds_min;
    draw();
    EXPECT_GT(center().brightness(), 100);
    EXPECT_LT(at(200, 120).brightness(), 42);
}

TEST_P(RendererTest, SizesAndSampleCountsMayChangeFromFrameToFrame) {
    const Shape shape = sphere(1);
    frame.primitives = {shape.primitives()};
    for (const int samples : {1, 4, 1, 4, 64})
        for (const int width : {320, 64, 333}) {
            frame.samples = samples;
            frame.width = width;
            draw();
            EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * width * 240));
            EXPECT_GT(center().brightness(), 150) << samples << ' ' << width;
        }
}

TEST(Backends, OfThisMachineAreNamedAndTheRestSayWhyNot) {
    const auto& available = available_backends();
    ASSERT_FALSE(available.empty()) << "this machine has no OpenGL at all";
    for (const Backend backend : {Backend::egl_device, Backend::egl_surfaceless, Backend::osmesa}) {
        EXPECT_EQ(backend_named(name_of(backend)), backend);
        if (std::find(available.begin(), available.end(), backend) == available.end()) {
            EXPECT_THROW(Renderer{backend}, Error);
            continue;
        }
        const Renderer renderer(backend);
        EXPECT_FALSE(renderer.gl_renderer().empty());
        EXPECT_THAT(renderer.selection(), testing::StartsWith(name_of(backend)));
    }
    EXPECT_THROW(static_cast<void>(backend_named("glx")), Error);
    EXPECT_EQ(Renderer(Backend::automatic).backend(), available.front());
}

TEST(Backends, TwoAliveInOneThreadDoNotDisturbEachOther) {
    const Shape shape = sphere(1);
    Frame frame = front_view();
    frame.primitives = {shape.primitives()};
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (const Backend backend : available_backends())
        for (int i = 0; i < 2; ++i) renderers.push_back(std::make_unique<Renderer>(backend));
    for (int round = 0; round < 2; ++round)
        for (const auto& renderer : renderers) {
            Image image;
            renderer->draw(frame, image);
            EXPECT_GT(image.rgb[3 * (120 * 320 + 160)], 150) << renderer->selection();
        }
}

TEST(DefaultCamera, ShowsTheWholeBoxWithASmallMargin) {
    Renderer renderer(Backend::automatic);
    for (const Vec3d size :
         {Vec3d{1, 1, 1}, Vec3d{10, 1, 1}, Vec3d{1, 1, 8}, Vec3d{1e-5, 2e-5, 1e-5}, Vec3d{1, 1, 0}}) {
        for (const double aspect : {16.0 / 9, 0.5}) {
            Frame frame = front_view(static_cast<int>(360 * aspect), 360);
            frame.bounds_min = {1, 2, 3};
            frame.bounds_max = {1 + size[0], 2 + size[1], 3 + size[2]};
            frame.origin = {1, 2, 3};
            frame.camera = annotations::default_camera(frame.bounds_min, frame.bounds_max, aspect);
            frame.background_top = frame.background_bottom = {0, 0, 0};
            Shape box;
            for (unsigned corner = 0; corner < 8; ++corner)
                box.positions.push_back({static_cast<float>((corner & 1U) != 0 ? size[0] : 0),
                                         static_cast<float>((corner & 2U) != 0 ? size[1] : 0),
                                         static_cast<float>((corner & 4U) != 0 ? size[2] : 0)});
            box.indices = {0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                           2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5};
            frame.primitives = {box.primitives()};
            Image image;
            renderer.draw(frame, image);
            int left = image.width, right = -1, top = image.height, bottom = -1;
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    if (image.rgb[3 * static_cast<std::size_t>(y * image.width + x)] > 0) {
                        left = std::min(left, x);
                        right = std::max(right, x);
                        top = std::min(top, y);
                        bottom = std::max(bottom, y);
                    }
            EXPECT_GT(left, 0);
            EXPECT_GT(top, 0);
            EXPECT_LT(right, image.width - 1);
            EXPECT_LT(bottom, image.height - 1);
            const double filled = std::max(static_cast<double>(right - left) / image.width,
                                           static_cast<double>(bottom - top) / image.height);
            EXPECT_GT(filled, 0.7) << size[0] << ' ' << size[1] << ' ' << size[2] << ' ' << aspect;
        }
    }
}

} // namespace
} // namespace server::render
