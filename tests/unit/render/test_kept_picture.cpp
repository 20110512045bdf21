// Renderers reuse parts of the last picture. Each frame of a sequence must equal the picture of a new renderer.
#include "counted_gl.hpp"
#include "render/painter.hpp"
#include "render/renderer.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

class KeptPictureTest : public testing::Test {
protected:
    void SetUp() override {
        frame.width = 500; // not a multiple of the tile size
        frame.height = 330;
    }
    // Number of pixels that differ from a new renderer's picture.
    std::size_t wrong_pixels() {
        Renderer anew(Backend::automatic);
        Image expected;
        anew.draw(frame, expected);
        const Image& image = renderer.draw(frame);
        EXPECT_EQ(image.width, expected.width);
        EXPECT_EQ(image.rgb.size(), expected.rgb.size());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < std::min(image.rgb.size(), expected.rgb.size()); i += 3)
            wrong += std::equal(&expected.rgb[i], &expected.rgb[i] + 3, &image.rgb[i]) ? 0 : 1;
        return wrong;
    }
    void show(const Shape& shape, Vec3f to) {
        shapes.push_back(shape);
        for (Vec3f& position : shapes.back().positions)
            for (std::size_t k = 0; k < 3; ++k) position[k] += to[k];
        show_all();
    }
    void show_all() {
        frame.primitives.clear();
        for (const Shape& shape : shapes) frame.primitives.push_back(shape.primitives());
    }

    Renderer renderer{Backend::automatic};
    Frame frame = front_view();
    std::vector<Shape> shapes;
};

TEST_F(KeptPictureTest, ABallThatMovesLeavesNothingBehind) {
    for (const bool gradient : {false, true}) {
        frame.background_bottom = {0.1234F, 0.4567F, 0.7891F};
        frame.background_top = frame.background_bottom;
        if (gradient) frame.background_top = {0.9F, 0.2F, 0.333F};
        for (int step = 0; step < 8; ++step) {
            shapes.clear();
            show(sphere(0.15), {-1.1F + 0.3F * static_cast<float>(step), 0, 0.7F - 0.2F * static_cast<float>(step)});
            EXPECT_EQ(wrong_pixels(), 0U) << "gradient " << gradient << ", step " << step;
        }
    }
}

TEST_F(KeptPictureTest, LinesAndPointsThatMoveLeaveNothingBehind) {
    for (int step = 0; step < 6; ++step) {
        const float at = -1 + 0.35F * static_cast<float>(step);
        shapes.clear();
        Shape line;
        line.positions = {{at, 0, -0.8F}, {at + 0.6F, 0.2F, 0.75F}};
        line.indices = {0, 1};
        shapes = {line};
        show_all();
        frame.primitives[0].lines = true;
        frame.primitives[0].line_width = 9;
        frame.primitives.push_back(frame.primitives[0]);
        frame.primitives[1].lines = false;
        frame.primitives[1].points = true;
        frame.primitives[1].point_size = 33;
        EXPECT_EQ(wrong_pixels(), 0U) << step;
    }
}

TEST_F(KeptPictureTest, WritingComesAndGoes) {
    show(sphere(0.1), {0.6F, 0, 0});
    for (const char* title : {"", "Steady", "Steady as she goes", "", ""}) {
        frame.annotations.title = title;
        frame.annotations.triad = !std::string(title).empty();
        EXPECT_EQ(wrong_pixels(), 0U) << title;
    }
}

TEST_F(KeptPictureTest, WhateverComesBetween) {
    show(sphere(0.2), {-0.7F, 0, 0});
    const auto moved = [&](float by) {
        for (Vec3f& position : shapes[0].positions) position[0] += by;
        show_all();
        return wrong_pixels();
    };
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(0.1F), 0U);
    frame.samples = 4;
    EXPECT_EQ(moved(0.1F), 0U) << "a still";
    frame.samples = 1;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(0.1F), 0U) << "after a still";
    frame.width = 333;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(-0.1F), 0U) << "another size";
    frame.background_bottom = frame.background_top = {1, 1, 0.5F};
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(0.1F), 0U) << "another background";
    frame.camera.position = {0, -0.05, 0}; // the eye is inside the bounds, so geometry behind the eye may be anywhere
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(0.05F), 0U) << "close by";
    frame.camera.position = {0, -5, 0};
    frame.primitives[0].color[3] = 0.5F;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(wrong_pixels(), 0U) << "transparent";
    frame.primitives.clear();
    for (int i = 0; i < 3; ++i) EXPECT_EQ(wrong_pixels(), 0U) << "nothing";
    frame.camera.fov_degrees = 500;
    EXPECT_THROW((void)renderer.draw(frame), Error);
    frame.camera.fov_degrees = 30;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(moved(0.1F), 0U) << "after an error";
}

TEST_F(KeptPictureTest, NothingIsPickedWhereSomethingWas) {
    show(sphere(0.15), {-0.5F, 0, 0});
    for (int i = 0; i < 3; ++i) (void)renderer.draw(frame);
    Vec3d found{};
    const auto column_of = [&](double x) { return static_cast<int>(frame.width / 2 + x * 330 / (10 * 0.26795)); };
    EXPECT_TRUE(renderer.pick(column_of(-0.5), 165, found));
    EXPECT_NEAR(found[0], -0.5, 0.15);
    shapes.clear();
    show(sphere(0.15), {0.5F, 0, 0});
    (void)renderer.draw(frame);
    EXPECT_FALSE(renderer.pick(column_of(-0.5), 165, found));
    EXPECT_TRUE(renderer.pick(column_of(0.5), 165, found));
}

// Few pixels are read back where little is drawn.
TEST_F(KeptPictureTest, OnlyWhatIsDrawnIsRead) {
    ChosenContext chosen = make_context(Backend::automatic);
    ASSERT_TRUE(make_current(*chosen.context));
    Painter painter(counted_gl(*chosen.context));
    show(sphere(0.15), {-0.5F, 0, 0});
    const auto read = [&] {
        (void)take_counts();
        (void)painter.draw(frame, {});
        return take_counts().pixels_read;
    };
    EXPECT_EQ(read(), 500U * 330U);
    (void)read(); // the first reading stores the background
    const std::size_t small = read();
    EXPECT_GT(small, 0U);
    EXPECT_LE(small, 4U * TouchedTiles::side * TouchedTiles::side);
    frame.primitives.clear();
    EXPECT_EQ(read(), 0U);
}

} // namespace
} // namespace server::render
