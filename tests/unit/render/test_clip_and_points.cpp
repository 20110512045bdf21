// Clip planes cut every kind of primitive, in pictures and when picking. Points have their size in pixels.
#include "backends.hpp"
#include "scenes.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numbers>

namespace server::render {
using namespace ciel;
namespace {

class ClipAndPoints : public testing::TestWithParam<Backend> {
protected:
    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;

    ClipAndPoints() { frame.background_top = frame.background_bottom = {0, 0, 0}; }
    void draw() { renderer.draw(frame, image); }
    [[nodiscard]] int brightness(int x, int y) const {
        const std::uint8_t* p = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
        return (p[0] + p[1] + p[2]) / 3;
    }
    // Lit pixels in the left and in the right half of the picture.
    [[nodiscard]] std::array<int, 2> lit() const {
        std::array<int, 2> count{};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) count[x < image.width / 2 ? 0 : 1] += brightness(x, y) > 40 ? 1 : 0;
        return count;
    }
    bool picked(int x, int y) {
        Vec3d position{};
        return renderer.pick(x, y, position);
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, ClipAndPoints, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClipAndPoints);

TEST_P(ClipAndPoints, APlaneCutsSurfacesOpaqueAndTransparentAndWhatIsPicked) {
    const Shape shape = square(0);
    for (const float opacity : {1.0F, 0.5F})
        for (const int samples : {1, 4}) {
            frame.samples = samples;
            Primitives primitives = shape.primitives();
            primitives.scalars = {};
            primitives.lit = false;
            primitives.color = {1, 1, 1, opacity};
            frame.primitives = {primitives};
            frame.clip = {};
            draw();
            const std::array<int, 2> whole = lit();
            EXPECT_EQ(whole[0], whole[1]);
            EXPECT_TRUE(picked(200, 120));
            frame.clip = {{-1, 0, 0, 0}}; // keeps x <= 0
            draw();
            EXPECT_NEAR(lit()[0], whole[0], 240) << opacity;
            EXPECT_EQ(lit()[1], 0) << opacity;
            EXPECT_TRUE(picked(120, 120)) << opacity;
            EXPECT_FALSE(picked(200, 120)) << opacity;
            frame.clip = {{-1, 0, 0, 0}, {0, 0, 1, 0}}; // keeps x <= 0 and z >= 0
            draw();
            EXPECT_NEAR(lit()[0], whole[0] / 2, 240);
            EXPECT_FALSE(picked(120, 200));
            frame.clip = {};
            draw();
            EXPECT_EQ(lit(), whole) << "nothing is left of the planes";
        }
}

// Without clip planes, a lit surface of one color with normals is drawn by a shader program without plane code.
TEST_P(ClipAndPoints, ABallIsWholeAgainAfterAPlane) {
    const Shape ball = sphere(0.8);
    frame.primitives = {ball.primitives()};
    draw();
    const Image whole = image;
    frame.clip = {{-1, 0, 0, 0}};
    draw();
    EXPECT_NE(image.rgb, whole.rgb);
    frame.clip = {};
    draw();
    EXPECT_EQ(image.rgb, whole.rgb);
    frame.clip = {{0, 0, 0, 1}}; // keeps everything, but selects the program with plane code
    draw();
    std::size_t differing = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) differing += std::abs(image.rgb[i] - whole.rgb[i]) > 1 ? 1 : 0;
    EXPECT_EQ(differing, 0U) << "both programs draw the same";
}

TEST_P(ClipAndPoints, APlaneCutsLinesAndPoints) {
    const std::vector<Vec3f> ends{{-1.5F, 0, 0}, {1.5F, 0, 0}};
    const Primitives line = line_between(ends, 6);
    Primitives points = line;
    points.lines = false;
    points.points = true;
    points.point_size = 20;
    for (const Primitives& primitives : {line, points}) {
        frame.primitives = {primitives};
        frame.clip = {};
        draw();
        const std::array<int, 2> whole = lit();
        EXPECT_GT(whole[0], 100);
        EXPECT_NEAR(whole[0], whole[1], 10);
        frame.clip = {{-1, 0, 0, 0}};
        draw();
        EXPECT_NEAR(lit()[0], whole[0], 10);
        EXPECT_EQ(lit()[1], 0);
    }
}

TEST_P(ClipAndPoints, APointIsADiscOfItsSizeThatSurfacesHide) {
    const std::vector<Vec3f> center{{0, 0, 0}};
    const std::vector<Index> one{0};
    Primitives point;
    point.positions = center;
    point.indices = one;
    point.points = true;
    point.color = {1, 1, 1, 1};
    for (const float size : {4.0F, 11.0F, 40.0F}) {
        point.point_size = size;
        frame.primitives = {point};
        draw();
        const double area = lit()[0] + lit()[1];
        EXPECT_NEAR(std::sqrt(area * 4 / std::numbers::pi), size, 1.2) << "across";
        EXPECT_TRUE(picked(160, 120));
    }
    const Shape wall = square(-0.5);
    Primitives hiding = wall.primitives();
    hiding.scalars = {};
    hiding.lit = false;
    hiding.color = {0, 0, 0, 1};
    frame.primitives = {point, hiding};
    draw();
    EXPECT_EQ(lit()[0] + lit()[1], 0);
}

TEST_P(ClipAndPoints, MorePlanesThanThereAreAreRefused) {
    const Shape shape = square(0);
    frame.primitives = {shape.primitives()};
    frame.clip.assign(6, {0, 0, 0, 1});
    EXPECT_NO_THROW(draw());
    frame.clip.assign(7, {0, 0, 0, 1});
    EXPECT_THROW(draw(), Error);
    frame.clip.clear();
    EXPECT_NO_THROW(draw());
}

} // namespace
} // namespace server::render
