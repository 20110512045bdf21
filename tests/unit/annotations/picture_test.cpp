// Annotations as pixels, on every back end of this machine.
#include "annotated_frames.hpp"
#include "annotations/layout.hpp"
#include "color/color_map.hpp"
#include "fonts/font.hpp"
#include "support/golden/golden.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::annotations {
using namespace server::render;
using namespace ciel;
namespace {

class AnnotationPicture : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Image image;

    const Image& draw(const Frame& frame) {
        renderer.draw(frame, image);
        return image;
    }
    [[nodiscard]] test::Picture picture() const { return {image.width, image.height, image.rgb}; }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
    }
    [[nodiscard]] static std::string label() { return name_of(GetParam()); }
};

std::string backend_test_name(const testing::TestParamInfo<Backend>& backend) {
    std::string name = name_of(backend.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Backends, AnnotationPicture, testing::ValuesIn(available_backends()), backend_test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(AnnotationPicture);

void paint_light(Frame& frame) {
    frame.background_top = {1, 1, 1};
    frame.background_bottom = {0.9F, 0.92F, 0.95F};
}

TEST_P(AnnotationPicture, LooksAsItDid) {
    const Shape ball = sphere(1);
    const Shape wall = square(1);
    for (const bool light : {false, true})
        for (const auto& [width, height] : {std::pair(640, 360), {1280, 720}}) {
            Frame frame = annotated_frame(width, height);
            if (light) paint_light(frame);
            frame.samples = 4;
            frame.primitives = {wall.primitives(), ball.primitives()};
            frame.primitives[0].scale.range = {-1, 1};
            draw(frame);
            const std::string name =
                std::string("annotations_") + (light ? "light_" : "dark_") + std::to_string(height);
            EXPECT_TRUE(test::matches_golden(name, picture(), label()));
        }
}

TEST_P(AnnotationPicture, LeavesThePictureAloneWhereItWritesNothing) {
    Frame frame = annotated_frame(320, 200);
    frame.annotations = {};
    const std::vector<std::uint8_t> plain = draw(frame).rgb;
    frame.annotations.title = "Title";
    draw(frame);
    fonts::Font font;
    const annotations::Overlay overlay = annotations::lay_out(frame, font);
    const annotations::Box& box = overlay.labels.at(0).box;
    int changed = 0;
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 320; ++x) {
            const bool is_as_before =
                std::equal(at(x, y), at(x, y) + 3, &plain[3 * static_cast<std::size_t>(y * 320 + x)]);
            changed += is_as_before ? 0 : 1;
            if (x < box.left - 3 || x > box.right + 3 || y < box.top - 3 || y > box.bottom + 3) {
                ASSERT_TRUE(is_as_before) << x << ' ' << y;
            }
        }
    EXPECT_GT(changed, 60);
}

// Glyph texels map to whole pixels: pixels that FreeType covers completely have the color of the ink, at 1 and 4
// samples.
TEST_P(AnnotationPicture, LettersArePixelsOfTheFont) {
    Frame frame = annotated_frame(960, 600);
    frame.annotations = {};
    frame.annotations.captions = {"HIlT"};
    frame.annotations.scale = 4; // large enough for strokes that cover whole pixels
    fonts::Font font;
    const annotations::Label label = annotations::lay_out(frame, font).labels.at(0);
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        draw(frame);
        int covered = 0;
        for (const auto& [glyph, x] : font.shape(label.text, label.pixels).glyphs) {
            const fonts::GlyphImage letter = font.draw(glyph, label.pixels);
            for (int row = 0; row < letter.height; ++row)
                for (int column = 0; column < letter.width; ++column) {
                    if (letter.coverage[2 * static_cast<std::size_t>(row * letter.width + column)] < 255) continue;
                    ++covered;
                    const std::uint8_t* seen = at(label.x + x + letter.left + column, label.y - letter.top + row);
                    ASSERT_NEAR(seen[0], 255 * label.ink[0], 1) << samples;
                    ASSERT_NEAR(seen[2], 255 * label.ink[2], 1) << samples;
                }
        }
        EXPECT_GT(covered, 50);
    }
}

TEST_P(AnnotationPicture, TheBarHasTheColorsOfTheMap) {
    Frame frame = annotated_frame(640, 400);
    frame.annotations = {};
    frame.annotations.legends = {{"p", "Pa", scale_of("plasma", {0, 1})}};
    fonts::Font font;
    const annotations::Overlay overlay = annotations::lay_out(frame, font);
    const annotations::Box lowest = overlay.fills.back().box;
    const annotations::Box highest = overlay.fills.at(1).box; // the last color of the bar; fills[0] is the bar's frame
    draw(frame);
    const std::string map = "plasma";
    const int top = static_cast<int>(highest.top);
    const int height = static_cast<int>(lowest.bottom) - top;
    for (int row = 0; row < height; ++row) {
        const auto& expected = color::color_map(map)[static_cast<std::size_t>(255 * (1 - (row + 0.5) / height))];
        const std::uint8_t* seen = at(static_cast<int>(lowest.left) + 3, top + row);
        for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(seen[k], expected[k], 4) << row;
    }
}

// White text on a white surface with a dark background, and dark text on a dark surface with a light one. The halo
// provides the contrast.
TEST_P(AnnotationPicture, TextIsLegibleOnASurfaceOfItsOwnColor) {
    const Shape wall = square(0);
    for (const bool light : {false, true}) {
        Frame frame = front_view(320, 240);
        if (light) paint_light(frame);
        Primitives primitives = wall.primitives();
        primitives.scalars = {};
        primitives.lit = false;
        primitives.color = light ? std::array{0.07F, 0.08F, 0.10F, 1.0F} : std::array{0.93F, 0.94F, 0.96F, 1.0F};
        frame.camera.parallel_height = 1; // the surface fills the picture
        frame.primitives = {primitives};
        frame.annotations.title = "legible";
        draw(frame);
        int contrary = 0;
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) contrary += light == (image.rgb[i] > 128) ? 1 : 0;
        EXPECT_GT(contrary, 60) << light;
    }
}

TEST_P(AnnotationPicture, ManySizesOneAfterTheOtherStayRight) {
    const Frame usual = annotated_frame(640, 360);
    const std::vector<std::uint8_t> first = draw(usual).rgb;
    for (const double scale : {0.25, 0.7, 1.3, 2.0, 3.1, 4.0})
        for (const int height : {200, 720, 2160}) { // more glyphs than the first texture atlas can hold
            Frame other = annotated_frame(height * 16 / 9, height);
            other.annotations.scale = scale;
            draw(other);
        }
    EXPECT_EQ(draw(usual).rgb, first);
    renderer.simulate_context_loss();
    EXPECT_EQ(draw(usual).rgb, first);
}

TEST_P(AnnotationPicture, PickStillFindsTheSurfaceBehindText) {
    const Shape wall = square(0);
    Frame frame = front_view();
    frame.primitives = {wall.primitives()};
    frame.annotations = all_annotations();
    draw(frame);
    Vec3d found{};
    ASSERT_TRUE(renderer.pick(160, 120, found));
    EXPECT_NEAR(found[1], 0, 1e-3);
    EXPECT_FALSE(renderer.pick(160, 12, found)) << "a title is nothing to hit";
}

} // namespace
} // namespace server::annotations
