// With the default tolerance, the golden comparison accepts all back ends of this machine and detects small changes.
#include "render/renderer.hpp"
#include "support/golden/golden.hpp"
#include "support/meshes.hpp"
#include "unit/render/scenes.hpp"
#include "unit/render/volume_scene.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

// An opaque ball and a transparent one in front of a colored square.
struct Stage {
    Shape ball = sphere(0.6, {-0.5, 0, 0});
    Shape bubble = sphere(0.7, {0.5, -0.3, 0.1});
    Shape wall = square(1);
    Frame frame = front_view(640, 360);

    explicit Stage(float opacity = 0.5F, double turn_degrees = 0, double tilt_degrees = 0) {
        const double turn = turn_degrees * std::numbers::pi / 180;
        const double tilt = tilt_degrees * std::numbers::pi / 180;
        frame.camera.parallel = false;
        frame.camera.position = {6 * std::sin(turn) * std::cos(tilt), -6 * std::cos(turn) * std::cos(tilt),
                                 6 * std::sin(tilt)};
        frame.samples = 4;
        frame.primitives = {ball.primitives(), wall.primitives(), bubble.primitives()};
        frame.primitives[0].color = {0.2F, 0.5F, 0.9F, 1};
        frame.primitives[1].scale.range = {-1, 1};
        frame.primitives[2].color = {0.9F, 0.6F, 0.2F, opacity};
    }
    [[nodiscard]] test::Picture draw(Renderer& renderer) const {
        Image image;
        renderer.draw(frame, image);
        return {image.width, image.height, image.rgb};
    }
};

TEST(GoldenPicture, IsTheSameOnEveryBackend) {
    for (const Backend backend : available_backends()) {
        Renderer renderer(backend);
        EXPECT_TRUE(test::matches_golden("two_balls", Stage().draw(renderer), name_of(backend)));
    }
}

TEST(GoldenPicture, CatchesASmallChangeOfTheCameraOrOfAnOpacity) {
    Renderer renderer(Backend::automatic);
    const test::Picture usual = Stage().draw(renderer);
    struct Row {
        const char* name;
        Stage stage;
    };
    for (const Row& row : {Row{"2 degrees to the right", Stage(0.5F, 2)}, Row{"2 degrees up", Stage(0.5F, 0, 2)},
                           Row{"1 degree to the left", Stage(0.5F, -1)}, Row{"opacity 0.53", Stage(0.53F)},
                           Row{"opacity 0.47", Stage(0.47F)}, Row{"opacity 3 % of itself less", Stage(0.485F)}}) {
        const test::Difference found = difference(usual, row.stage.draw(renderer));
        EXPECT_FALSE(is_within(found, {})) << row.name << ": " << words(found, {});
    }
}

// A shaded ball of fog, densest in its middle.
struct FogStage {
    VolumeScene fog{test::hexahedra({{6, 6, 6}, -1, 1, 1.0 / 3}),
                    [](const Vec3d& p) { return std::hypot(p[0], p[1], p[2]); }};
    Frame frame = front_view(480, 270);

    test::Picture draw(Renderer& renderer, double opacity = 1, double turn_degrees = 0, double tilt_degrees = 0) {
        const double turn = turn_degrees * std::numbers::pi / 180, tilt = tilt_degrees * std::numbers::pi / 180;
        frame.camera.parallel = false;
        frame.camera.position = {6 * std::sin(0.4 + turn) * std::cos(0.3 + tilt),
                                 -6 * std::cos(0.4 + turn) * std::cos(0.3 + tilt), 6 * std::sin(0.3 + tilt)};
        frame.samples = 4;
        Volume volume = fog.volume({0, 1, 0}, 60);
        volume.scale.map = "viridis";
        volume.scale.range = {0, 1.6F};
        volume.opacity_points = {{0, 0.9 * opacity}, {0.5, 0.4 * opacity}, {1, 0.1 * opacity}};
        volume.unit_length = 1;
        volume.shaded = true;
        frame.volumes = {volume};
        Image image;
        renderer.draw(frame, image);
        return {image.width, image.height, image.rgb};
    }
};

TEST(GoldenPicture, CatchesASmallChangeOfAVolume) {
    Renderer renderer(Backend::automatic);
    FogStage stage;
    const test::Picture usual = stage.draw(renderer);
    struct Row {
        const char* name;
        double opacity, turn, tilt;
    };
    for (const Row& row : {Row{"opacity 3 % less", 0.97, 0, 0}, Row{"opacity 3 % more", 1.03, 0, 0},
                           Row{"2 degrees to the right", 1, 2, 0}, Row{"2 degrees up", 1, 0, 2}}) {
        const test::Difference found = difference(usual, stage.draw(renderer, row.opacity, row.turn, row.tilt));
        EXPECT_FALSE(is_within(found, {})) << row.name << ": " << words(found, {});
    }
    EXPECT_TRUE(is_within(difference(usual, stage.draw(renderer)), {}));
}

class GoldenFailure : public testing::Test {
protected:
    void SetUp() override { unsetenv("CIEL_ACCEPT_PICTURES"); }
    [[nodiscard]] static std::filesystem::path kept(const std::string& name) {
        return std::filesystem::path(CIEL_BINARY_DIR) / "pictures/golden" / name;
    }
};

TEST_F(GoldenFailure, KeepsWhatWasDrawnUntilItPasses) {
    const auto golden = test::read_png(std::filesystem::path(CIEL_SOURCE_DIR) / "tests/golden/pictures/two_balls.png");
    test::Picture spoiled = golden;
    for (std::size_t i = 0; i < 3000; ++i) spoiled.rgb[i] = 255;
    const testing::AssertionResult result = test::matches_golden("two_balls", spoiled, "spoiled");
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), testing::HasSubstr("two_balls.spoiled.actual.png"));
    EXPECT_EQ(test::read_png(kept("two_balls.spoiled.actual.png")).rgb, spoiled.rgb);
    EXPECT_EQ(test::read_png(kept("two_balls.spoiled.expected.png")).rgb, golden.rgb);
    EXPECT_TRUE(std::filesystem::exists(kept("two_balls.spoiled.difference.png")));
    EXPECT_TRUE(test::matches_golden("two_balls", golden, "spoiled"));
    EXPECT_FALSE(std::filesystem::exists(kept("two_balls.spoiled.actual.png")));
}

TEST_F(GoldenFailure, SaysWhatIsWrongWithTheFileOrTheSize) {
    const test::Picture small{2, 1, std::vector<std::uint8_t>(6)};
    const testing::AssertionResult absent = test::matches_golden("of_nothing", small);
    EXPECT_FALSE(absent);
    EXPECT_THAT(absent.message(), testing::HasSubstr("there is no golden image"));
    EXPECT_TRUE(std::filesystem::exists(kept("of_nothing.actual.png")));
    const testing::AssertionResult other = test::matches_golden("two_balls", small, "small");
    EXPECT_FALSE(other);
    EXPECT_THAT(other.message(), testing::HasSubstr("640 x 360, the picture 2 x 1"));
}

} // namespace
} // namespace server::render
