// Pictures of shapes whose look is known, on every back end of this machine. A failing picture stays in the build
// folder.
#include "render/color_map.hpp"
#include "scenes.hpp"
#include "wire/png.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::render {
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
        wire::encode_png(image.width, image.height, image.rgb, wire::PngEffort::interactive, png);
        std::ofstream(folder / (name + ".png"), std::ios::binary)
            .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    }
};

std::string backend_test_name(const testing::TestParamInfo<Backend>& backend) {
    std::string name = name_of(backend.param);
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Backends, RendererTest, testing::ValuesIn(available_backends()), backend_test_name);
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
            Mesh mesh = shape.mesh();
            std::vector<Vec3f> normals = shape.normals;
            if (inverted)
                for (Vec3f& n : normals) n = {-n[0], -n[1], -n[2]};
            mesh.normals = smooth ? std::span<const Vec3f>(normals) : std::span<const Vec3f>();
            frame.meshes = {mesh};
            draw();
            // A disc of radius 1 in a view of 3 x 4.
            const double covered = share([](Pixel p) { return p.brightness() > 42; });
            EXPECT_NEAR(covered, std::numbers::pi / 12, 0.004) << smooth << inverted;
            // Nothing inside nine tenths of the radius is dark.
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

} // namespace
} // namespace ciel::render
