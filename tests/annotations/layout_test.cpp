// The laws of every layout: text lies inside the picture and never on other text. In tables of sizes, scales and
// directions of view.
#include "pages.hpp"
#include "render/box_edges.hpp"
#include "render/make_room.hpp"
#include "render/page.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace ciel::render {
namespace {

class Layout : public testing::Test {
protected:
    Font font;

    void expect_lawful(const Frame& frame, const std::string& what) {
        const Overlay overlay = lay_out(frame, font);
        const Box all{0, 0, static_cast<double>(frame.width), static_cast<double>(frame.height)};
        for (std::size_t i = 0; i < overlay.labels.size(); ++i) {
            const Label& label = overlay.labels[i];
            EXPECT_TRUE(all.holds(label.box)) << what << ": " << label.text << " sticks out";
            if (is_of_triad(label)) continue; // its letters meet when an axis points at the viewer
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(label.box.overlaps(overlay.labels[j].box))
                    << what << ": " << label.text << " lies on " << overlay.labels[j].text;
        }
        for (const Fill& fill : overlay.fills) EXPECT_TRUE(all.holds(fill.box)) << what;
    }
    static bool is_of_triad(const Label& label) { return label.ink[0] != label.ink[1] && label.text.size() == 1; }
    [[nodiscard]] static const Label* find(const Overlay& overlay, const std::string& text) {
        const auto found = std::find_if(overlay.labels.begin(), overlay.labels.end(),
                                        [&](const Label& label) { return label.text == text; });
        return found == overlay.labels.end() ? nullptr : &*found;
    }
};

TEST_F(Layout, IsLawfulAtAnySize) {
    for (const auto& [width, height] : {std::pair(16, 16),
                                        {64, 48},
                                        {100, 400},
                                        {400, 100},
                                        {320, 200},
                                        {640, 360},
                                        {1280, 720},
                                        {1920, 1080},
                                        {720, 1280},
                                        {4096, 4096},
                                        {8192, 512},
                                        {16, 8192}})
        for (const double scale : {0.25, 1.0, 2.0, 4.0}) {
            Frame frame = annotated_frame(width, height);
            frame.annotations.scale = scale;
            expect_lawful(frame, std::to_string(width) + "x" + std::to_string(height) + " *" + std::to_string(scale));
        }
}

TEST_F(Layout, IsLawfulFromAnywhere) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> distance(0, 12);
    for (int round = 0; round < 400; ++round) {
        Frame frame = annotated_frame(640, 400);
        const double far = distance(random);
        const Vec3d direction{normal(random), normal(random), normal(random)};
        const double length = std::hypot(direction[0], direction[1], direction[2]);
        frame.camera.target = {1, 0, 0};
        for (std::size_t k = 0; k < 3; ++k)
            frame.camera.position[k] = frame.camera.target[k] + direction[k] / length * far;
        frame.camera.parallel = round % 3 == 0;
        frame.camera.parallel_height = 0.5 + far;
        expect_lawful(frame, "round " + std::to_string(round));
    }
}

TEST_F(Layout, IsLawfulForAnyText) {
    Frame frame = annotated_frame(640, 360);
    frame.annotations.title = std::string(5000, 'W');
    frame.annotations.captions = {std::string(300, '\xFF'), "", "a\nb", std::string(40, 'i')};
    frame.annotations.captions.resize(80, "line");
    for (Legend& legend : frame.annotations.legends) legend.name = "an array with a name that is far too long";
    frame.annotations.legends.resize(64, {"n", "", scale_of("magma", {1e30F, 1e38F})});
    expect_lawful(frame, "long");
    for (const auto& range :
         {std::array{0.0F, 0.0F}, {NAN, NAN}, {-INFINITY, INFINITY}, {2.0F, 1.0F}, {-1e38F, 1e38F}}) {
        frame.annotations.legends = {{"q", "", scale_of("magma", range)}};
        expect_lawful(frame, "range");
    }
    ColorScale odd = scale_of("magma", {1e-3F, 1e3F});
    odd.below = odd.above = Rgb8{255, 0, 255};
    for (const int steps : {0, 2, 7, 256})
        for (const bool log : {false, true}) {
            odd.steps = steps;
            odd.log = log;
            frame.annotations.legends = {{"q", "", odd}};
            expect_lawful(frame, "scale");
        }
}

TEST_F(Layout, HasAllItsPartsWhereThereIsRoom) {
    const Overlay overlay = lay_out(annotated_frame(1280, 720), font);
    for (const char* text :
         {"Wake of a sphere at Re 300 — ν = 1.5 µm²/s", "sphere_polyhedra", "Time: 0.35", "U:magnitude [m/s]",
          "p [m²/s²]", "T [°C] ×10⁻⁵", "1.43", "1.0", "−0.61", "−0.2", "3.4", "x [m]", "y [m]", "z [m]", "x", "y", "z"})
        EXPECT_NE(find(overlay, text), nullptr) << text;
}

TEST_F(Layout, HasOnlyWhatIsAskedFor) {
    Frame frame = annotated_frame(640, 360);
    const Annotations all = frame.annotations;
    frame.annotations = {};
    const Overlay none = lay_out(frame, font);
    EXPECT_TRUE(none.labels.empty() && none.fills.empty() && none.strokes.empty() && none.triangles.empty());
    frame.annotations.triad = true;
    EXPECT_EQ(lay_out(frame, font).labels.size(), 3U);
    frame.annotations = {};
    frame.annotations.title = all.title;
    EXPECT_EQ(lay_out(frame, font).labels.size(), 1U);
    frame.annotations = {};
    frame.annotations.legends = {all.legends[0]};
    EXPECT_NE(find(lay_out(frame, font), "U:magnitude [m/s]"), nullptr);
    EXPECT_EQ(find(lay_out(frame, font), "x [m]"), nullptr);
}

TEST_F(Layout, TextGrowsWithThePictureAndTheScale) {
    const auto pixels = [&](int width, int height, double scale) {
        Frame frame = annotated_frame(width, height);
        frame.annotations.scale = scale;
        return Page(frame, font).text().pixels;
    };
    EXPECT_EQ(pixels(1280, 720, 1), 13);
    EXPECT_EQ(pixels(2560, 1440, 1), 26);
    EXPECT_EQ(pixels(1280, 720, 2), 26);
    EXPECT_EQ(pixels(64, 64, 1), 9) << "never too small to be read";
    EXPECT_LT(pixels(360, 1280, 1), 13) << "a narrow picture has narrow text";
}

// Nothing of the box under the legends; all ticks' numbers in the picture; the same view for pictures of one shape.
TEST_F(Layout, HasAViewThatMakesRoomForIt) {
    for (const auto& [width, height] : {std::pair(640, 360), {1280, 720}, {900, 900}, {800, 1000}}) {
        Frame frame = annotated_frame(width, height);
        frame.camera = default_camera(frame.bounds_min, frame.bounds_max, static_cast<double>(width) / height);
        const Camera before = frame.camera;
        frame.camera = clear_of_annotations(frame);
        EXPECT_LT(frame.camera.position[1], before.position[1]) << "further away";
        const Overlay overlay = lay_out(frame, font);
        double legends = width;
        for (const Fill& fill : overlay.fills) legends = std::min(legends, fill.box.left);
        const Projection projection(frame);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const Place at = projection.pixel(
                {(corner & 1U) != 0 ? 3 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1});
            EXPECT_LT(at.x, legends) << width;
        }
        for (const char* text : {"x [m]", "y [m]", "z [m]"}) EXPECT_NE(find(overlay, text), nullptr) << width << text;
        frame.annotations = {};
        frame.camera = before;
        EXPECT_EQ(clear_of_annotations(frame).position, before.position) << "nothing is written";
    }
}

TEST_F(Layout, ContrastsWithTheBackground) {
    Frame frame = annotated_frame(640, 360);
    EXPECT_GT(Page(frame, font).ink()[0], 0.8F);
    frame.background_top = {1, 1, 1};
    frame.background_bottom = {0.9F, 0.92F, 0.95F};
    EXPECT_LT(Page(frame, font).ink()[0], 0.2F);
    EXPECT_GT(lay_out(frame, font).halo[0], 0.8F);
}

} // namespace
} // namespace ciel::render
