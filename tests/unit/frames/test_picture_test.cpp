#include "frames/test_picture.hpp"

#include <gtest/gtest.h>

namespace server::frames {
namespace {

constexpr std::size_t side = 32;

render::Image filled(std::array<std::uint8_t, 3> color) {
    render::Image image{side, side, {}};
    for (std::size_t i = 0; i < side * side; ++i) image.rgb.insert(image.rgb.end(), color.begin(), color.end());
    return image;
}

TEST(test_picture, of_a_renderer_that_draws_is_ready) {
    render::Renderer renderer(render::Backend::automatic);
    const TestPictureResult result = draw_test_picture(renderer);
    EXPECT_TRUE(result.passed);
    EXPECT_EQ(result.gl_renderer, renderer.gl_renderer());
    EXPECT_EQ(result.problem, "");
}

TEST(test_picture, with_wrong_pixels_is_not) {
    EXPECT_FALSE(is_test_picture({})) << "nothing";
    EXPECT_FALSE(is_test_picture(filled({0, 0, 0}))) << "nothing drawn";
    EXPECT_FALSE(is_test_picture(filled({255, 128, 0}))) << "the triangle covers the corners";
    render::Image image = filled({0, 0, 0});
    const std::size_t middle = 3 * (side / 2 * side + side / 2);
    image.rgb[middle] = 255;
    image.rgb[middle + 1] = 128;
    EXPECT_TRUE(is_test_picture(image));
    image.rgb[middle + 2] = 9;
    EXPECT_FALSE(is_test_picture(image)) << "another color";
}

} // namespace
} // namespace server::frames
