// Rules of every layout, for many sizes, scales and views: text is inside the picture and never overlaps other text.
#include "annotated_frames.hpp"
#include "annotations/box_edges.hpp"
#include "annotations/layout.hpp"
#include "annotations/make_room.hpp"
#include "fonts/font.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace server::annotations {
using namespace server::render;
using namespace ciel;
namespace {

class LayoutTest : public testing::Test {
protected:
    fonts::Font font;

    void expect_lawful(const Frame& frame, const std::string& what) {
        const annotations::Overlay overlay = annotations::lay_out(frame, font);
        const annotations::Box all{0, 0, static_cast<double>(frame.width), static_cast<double>(frame.height)};
        for (std::size_t i = 0; i < overlay.labels.size(); ++i) {
            const annotations::Label& label = overlay.labels[i];
            EXPECT_TRUE(all.holds(label.box)) << what << ": " << label.text << " sticks out";
            if (is_of_triad(label)) continue; // the triad's letters overlap when an axis points at the viewer
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(label.box.overlaps(overlay.labels[j].box))
                    << what << ": " << label.text << " lies on " << overlay.labels[j].text;
        }
        for (const annotations::Fill& fill : overlay.fills) EXPECT_TRUE(all.holds(fill.box)) << what;
        expect_apart(overlay, what);
    }
    // No color bar, triad, axis line or tick overlaps text.
    void expect_apart(const annotations::Overlay& overlay, const std::string& what) {
        const auto is_grey = [](const annotations::Ink& ink) { return std::abs(ink[0] - ink[2]) < 0.1F; };
        for (const annotations::Label& label : overlay.labels) {
            for (const annotations::Fill& fill : overlay.fills)
                EXPECT_FALSE(label.box.overlaps(fill.box)) << what << ": a color bar on " << label.text;
            if (is_of_triad(label)) continue;
            for (const annotations::Stroke& stroke : overlay.strokes)
                EXPECT_FALSE(annotations::part_inside(label.box, stroke.from, stroke.to))
                    << what << ": a line of " << (is_grey(stroke.ink) ? "an axis" : "the triad") << " on "
                    << label.text;
        }
        for (const annotations::Fill& fill : overlay.fills)
            for (const annotations::Stroke& stroke : overlay.strokes)
                EXPECT_FALSE(annotations::part_inside(fill.box, stroke.from, stroke.to))
                    << what << ": a line on a color bar";
    }
    static bool is_of_triad(const annotations::Label& label) {
        return label.ink[0] != label.ink[1] && label.text.size() == 1;
    }
    [[nodiscard]] static const annotations::Label* find(const annotations::Overlay& overlay, const std::string& text) {
        const auto found = std::find_if(overlay.labels.begin(), overlay.labels.end(),
                                        [&](const annotations::Label& label) { return label.text == text; });
        return found == overlay.labels.end() ? nullptr : &*found;
    }
};

TEST_F(LayoutTest, IsLawfulAtAnySize) {
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

TEST_F(LayoutTest, IsLawfulFromAnywhere) {
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

TEST_F(LayoutTest, IsLawfulForAnyText) {
    Frame frame = annotated_frame(640, 360);
    frame.annotations.title = std::string(5000, 'W');
    frame.annotations.captions = {std::string(300, '\xFF'), "", "a\nb", std::string(40, 'i')};
    frame.annotations.captions.resize(80, "line");
    for (annotations::Legend& legend : frame.annotations.legends)
        legend.name = "an array with a name that is far too long";
    frame.annotations.legends.resize(64, {"n", "", scale_of("magma", {1e30F, 1e38F})});
    expect_lawful(frame, "long");
    for (const auto& range : {std::array{0.0, 0.0}, {NAN, NAN}, {-INFINITY, INFINITY}, {2.0, 1.0}, {-1e38, 1e38}}) {
        frame.annotations.legends = {{"q", "", scale_of("magma", range)}};
        expect_lawful(frame, "range");
    }
    color::ColorScale odd = scale_of("magma", {1e-3F, 1e3F});
    odd.below = odd.above = color::Rgb8{255, 0, 255};
    for (const int steps : {0, 2, 7, 256})
        for (const bool log : {false, true}) {
            odd.steps = steps;
            odd.log = log;
            frame.annotations.legends = {{"q", "", odd}};
            expect_lawful(frame, "scale");
        }
}

// From nearby, the box and its axes extend below all other annotations.
TEST_F(LayoutTest, HasNothingOnAnythingElseWhereverTheBoxLies) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(-1, 1);
    for (const auto& [width, height] : {std::pair(320, 480), {240, 400}, {640, 360}, {1000, 300}})
        for (int round = 0; round < 60; ++round) {
            Frame frame = annotated_frame(width, height);
            const Vec3d direction{share(random), share(random), 0.6 * share(random)};
            const double far = 3 + 4 * std::abs(share(random));
            for (std::size_t k = 0; k < 3; ++k) {
                frame.camera.target[k] = (k == 0 ? 1 : 0) + 2 * share(random);
                frame.camera.position[k] = frame.camera.target[k] + far * direction[k] + (k == 1 ? -0.5 : 0);
            }
            frame.annotations.legends.resize(static_cast<std::size_t>(1 + round % 3));
            if (round % 2 == 0) frame.annotations.legends[0].layers = "Slice at z = 0.25";
            expect_lawful(frame, std::to_string(width) + " round " + std::to_string(round));
        }
}

TEST_F(LayoutTest, LinesEndAtTheEdgesOfABox) {
    const annotations::Box box{10, 10, 20, 30};
    const auto inside = [&](annotations::PicturePoint a, annotations::PicturePoint b) {
        return annotations::part_inside(box, a, b).value_or(std::pair(-1.0, -1.0));
    };
    EXPECT_EQ(inside({0, 20}, {40, 20}), std::pair(0.25, 0.5));
    EXPECT_EQ(inside({40, 20}, {0, 20}), std::pair(0.5, 0.75));
    EXPECT_EQ(inside({15, 0}, {15, 40}), std::pair(0.25, 0.75));
    EXPECT_EQ(inside({12, 12}, {18, 28}), std::pair(0.0, 1.0));
    EXPECT_EQ(inside({0, 0}, {30, 5}), std::pair(-1.0, -1.0)) << "above it";
    EXPECT_EQ(inside({0, 10}, {40, 10}), std::pair(-1.0, -1.0)) << "along its edge";
    EXPECT_EQ(inside({15, 20}, {15, 20}), std::pair(0.0, 1.0)) << "a point";
}

TEST_F(LayoutTest, TellsApartLegendsOfOneName) {
    Frame frame = annotated_frame(1280, 720);
    frame.annotations.legends = {{"p", "Pa", scale_of("viridis", {0, 1}), "Slice at z = 0.25"},
                                 {"p", "Pa", scale_of("magma", {0, 1}), "Boundary"}};
    const annotations::Overlay overlay = annotations::lay_out(frame, font);
    for (const char* name : {"Slice at z = 0.25", "Boundary"}) {
        const annotations::Label* layers = find(overlay, name);
        ASSERT_NE(layers, nullptr) << name;
        const annotations::Label* title = layers - 1;
        EXPECT_EQ(title->text, "p [Pa]");
        EXPECT_EQ(title->x, layers->x);
        EXPECT_LE(title->box.bottom, layers->box.top);
        EXPECT_LT(layers->y - title->y, 2 * (layers->box.bottom - layers->box.top)) << "right below it";
    }
}

// Legends leave most of a small picture free. The first ones stay, and a text gives the number of omitted ones.
TEST_F(LayoutTest, LeavesRoomForTheBoxInSmallPictures) {
    for (const auto& [width, height] : {std::pair(240, 400), {400, 240}, {320, 480}, {480, 320}, {640, 360}}) {
        Frame frame = annotated_frame(width, height);
        frame.annotations.legends.push_back({"s", "", scale_of("magma", {0, 1})});
        for (annotations::Legend& legend : frame.annotations.legends) legend.layers = "Slice";
        const annotations::Overlay overlay = annotations::lay_out(frame, font);
        const std::string what = std::to_string(width) + "x" + std::to_string(height);
        double covered = 0;
        int bars = 0;
        for (const annotations::Plate& plate : overlay.plates) {
            const bool is_legend =
                std::any_of(overlay.fills.begin(), overlay.fills.end(),
                            [&](const annotations::Fill& fill) { return plate.box.overlaps(fill.box); });
            covered += is_legend ? plate.box.width() * plate.box.height() : 0;
            bars += is_legend ? 1 : 0;
        }
        EXPECT_GE(bars, 1) << what;
        EXPECT_LT(covered, 0.25 * width * height) << what;
        if (width == 240) {
            EXPECT_NE(find(overlay, "+ " + std::to_string(4 - bars) + " more"), nullptr) << what;
        }
        const auto is_first = [](const annotations::Label& label) { return label.text.starts_with("U:ma"); };
        EXPECT_TRUE(std::any_of(overlay.labels.begin(), overlay.labels.end(), is_first)) << what;
        expect_lawful(frame, what);
    }
}

TEST_F(LayoutTest, ShowsTheColorOfMissingValuesWhereThereAreSome) {
    Frame frame = annotated_frame(1280, 720);
    EXPECT_EQ(find(annotations::lay_out(frame, font), "no value"), nullptr);
    frame.annotations.legends[1].missing = true;
    frame.annotations.legends[1].scale.nan = {255, 0, 255};
    const annotations::Overlay overlay = annotations::lay_out(frame, font);
    const annotations::Label* name = find(overlay, "no value");
    ASSERT_NE(name, nullptr);
    const auto is_magenta = [](const annotations::Fill& fill) { return fill.top == annotations::Ink{1, 0, 1, 1}; };
    const auto patch = std::find_if(overlay.fills.begin(), overlay.fills.end(), is_magenta);
    ASSERT_NE(patch, overlay.fills.end());
    EXPECT_LT(patch->box.right, name->box.left);
    EXPECT_GT(patch->box.bottom, name->box.top);
    for (const auto& [width, height] : {std::pair(240, 400), {640, 360}, {1280, 720}, {1920, 300}}) {
        Frame other = annotated_frame(width, height);
        for (annotations::Legend& legend : other.annotations.legends) {
            legend.missing = true;
            legend.scale.below = legend.scale.above = color::Rgb8{0, 255, 0};
        }
        expect_lawful(other, std::to_string(width) + " with missing values");
    }
}

TEST_F(LayoutTest, MarksOfStepsCanBeToldApartHoweverManyThereAre) {
    for (const auto& [width, height] : {std::pair(320, 200), {500, 320}, {1280, 720}, {4096, 4096}})
        for (int steps = 2; steps <= color::most_color_steps; ++steps) {
            Frame frame = annotated_frame(width, height);
            frame.annotations = {};
            frame.annotations.legends = {{"p", "", scale_of("viridis", {0, 1})}};
            frame.annotations.legends[0].scale.steps = steps;
            const annotations::Overlay overlay = annotations::lay_out(frame, font);
            std::set<double> places;
            for (const annotations::Stroke& stroke : overlay.strokes) places.insert(stroke.from.y);
            ASSERT_GE(places.size(), 2U) << steps;
            for (auto next = std::next(places.begin()); next != places.end(); ++next)
                EXPECT_GT(*next - *std::prev(next), 3 * overlay.strokes[0].width) << steps << " at " << width;
        }
}

TEST_F(LayoutTest, HasAllItsPartsWhereThereIsRoom) {
    const annotations::Overlay overlay = annotations::lay_out(annotated_frame(1280, 720), font);
    for (const char* text :
         {"Wake of a sphere at Re 300 — ν = 1.5 µm²/s", "sphere_polyhedra", "Time: 0.35", "U:magnitude [m/s]",
          "p [m²/s²]", "T [°C] ×10⁻⁵", "1.43", "1.0", "−0.61", "−0.2", "3.4", "x [m]", "y [m]", "z [m]", "x", "y", "z"})
        EXPECT_NE(find(overlay, text), nullptr) << text;
}

TEST_F(LayoutTest, HasOnlyWhatIsAskedFor) {
    Frame frame = annotated_frame(640, 360);
    const annotations::Annotations all = frame.annotations;
    frame.annotations = {};
    const annotations::Overlay none = annotations::lay_out(frame, font);
    EXPECT_TRUE(none.labels.empty() && none.fills.empty() && none.strokes.empty() && none.triangles.empty());
    frame.annotations.triad = true;
    EXPECT_EQ(annotations::lay_out(frame, font).labels.size(), 3U);
    frame.annotations = {};
    frame.annotations.title = all.title;
    EXPECT_EQ(annotations::lay_out(frame, font).labels.size(), 1U);
    frame.annotations = {};
    frame.annotations.legends = {all.legends[0]};
    EXPECT_NE(find(annotations::lay_out(frame, font), "U:magnitude [m/s]"), nullptr);
    EXPECT_EQ(find(annotations::lay_out(frame, font), "x [m]"), nullptr);
}

TEST_F(LayoutTest, TextGrowsWithThePictureAndTheScale) {
    const auto pixels = [&](int width, int height, double scale) {
        Frame frame = annotated_frame(width, height);
        frame.annotations.scale = scale;
        return annotations::Layout(frame, font).text().pixels;
    };
    EXPECT_EQ(pixels(1280, 720, 1), 13);
    EXPECT_EQ(pixels(2560, 1440, 1), 26);
    EXPECT_EQ(pixels(1280, 720, 2), 26);
    EXPECT_EQ(pixels(64, 64, 1), 9) << "never too small to be read";
    EXPECT_LT(pixels(360, 1280, 1), 13) << "a narrow picture has narrow text";
}

// Moves the camera back until the box is clear of the legends and all tick numbers are inside the picture.
TEST_F(LayoutTest, HasAViewThatMakesRoomForIt) {
    for (const auto& [width, height] :
         {std::pair(640, 360), {1280, 720}, {900, 900}, {800, 1000}, {320, 480}, {480, 400}}) {
        Frame frame = annotated_frame(width, height);
        frame.camera =
            annotations::default_camera(frame.bounds_min, frame.bounds_max, static_cast<double>(width) / height);
        const annotations::ViewCamera before = frame.camera;
        frame.camera = annotations::clear_of_annotations(frame, font);
        EXPECT_LT(frame.camera.position[1], before.position[1]) << "further away";
        const annotations::Overlay overlay = annotations::lay_out(frame, font);
        double legends = width;
        for (const annotations::Fill& fill : overlay.fills) legends = std::min(legends, fill.box.left);
        const annotations::Projection projection(frame);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const annotations::PicturePoint at = projection.pixel(
                {(corner & 1U) != 0 ? 3 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1});
            EXPECT_LT(at.x, legends) << width;
        }
        for (const char* text : {"x [m]", "y [m]", "z [m]"}) EXPECT_NE(find(overlay, text), nullptr) << width << text;
        frame.annotations = {};
        frame.camera = before;
        EXPECT_EQ(annotations::clear_of_annotations(frame, font).position, before.position) << "nothing is written";
    }
}

TEST_F(LayoutTest, ContrastsWithTheBackground) {
    Frame frame = annotated_frame(640, 360);
    EXPECT_GT(annotations::Layout(frame, font).ink()[0], 0.8F);
    frame.background_top = {1, 1, 1};
    frame.background_bottom = {0.9F, 0.92F, 0.95F};
    EXPECT_LT(annotations::Layout(frame, font).ink()[0], 0.2F);
    EXPECT_GT(annotations::lay_out(frame, font).halo[0], 0.8F);
}

} // namespace
} // namespace server::annotations
