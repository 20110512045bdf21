// Contrast of all text (WCAG 2.1) with the pixels around its letters, over any picture.
#include "annotated_frames.hpp"
#include "annotations/layout.hpp"
#include "fonts/font.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace server::annotations {
using namespace server::render;
using namespace ciel;
namespace {

constexpr double least_contrast = 4.5; // WCAG success criterion 1.4.3, normal text

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const std::uint8_t* rgb) {
    return 0.2126 * linear(rgb[0] / 255.0) + 0.7152 * linear(rgb[1] / 255.0) + 0.0722 * linear(rgb[2] / 255.0);
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

// Share of each pixel of a label's box that letters cover, from 0 to 1.
std::vector<double> cover_of(const annotations::Label& label, fonts::Font& font, int width, int height) {
    std::vector<double> cover(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0);
    const int left = static_cast<int>(label.box.left);
    const int top = static_cast<int>(label.box.top);
    for (const auto& [glyph, x] : font.shape(label.text, label.pixels).glyphs) {
        const fonts::GlyphImage letter = font.draw(glyph, label.pixels);
        for (int row = 0; row < letter.height; ++row)
            for (int column = 0; column < letter.width; ++column) {
                const int at_x = label.x + x + letter.left + column - left;
                const int at_y = label.y - letter.top + row - top;
                if (at_x < 0 || at_y < 0 || at_x >= width || at_y >= height) continue;
                double& here = cover[static_cast<std::size_t>(at_y * width + at_x)];
                const auto texel = static_cast<std::size_t>(row * letter.width + column);
                here = std::max(here, letter.coverage[2 * texel] / 255.0);
            }
    }
    return cover;
}

struct Seen {
    std::vector<double> letters, around; // luminances of pixels inside and around letters
};

Seen seen_of(const annotations::Label& label, fonts::Font& font, const Image& image) {
    const int width = static_cast<int>(label.box.width());
    const int height = static_cast<int>(label.box.height());
    const std::vector<double> cover = cover_of(label, font, width, height);
    Seen seen;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int row = static_cast<int>(label.box.top) + y;
            const int column = static_cast<int>(label.box.left) + x;
            if (row < 0 || column < 0 || row >= image.height || column >= image.width) continue;
            const double here =
                luminance(&image.rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                          static_cast<std::size_t>(column))]);
            const double part = cover[static_cast<std::size_t>(y * width + x)];
            if (part > 0.9) seen.letters.push_back(here);
            if (part == 0) seen.around.push_back(here);
        }
    return seen;
}

// Covers more than the camera's view.
Shape wall() {
    Shape shape = grid(500, 300, [](double u, double v) {
        return Vec3f{static_cast<float>(8 * u - 4), 0, static_cast<float>(6 * v - 3)};
    });
    std::mt19937 random(7);
    for (std::size_t i = 0; i < shape.positions.size(); ++i)
        shape.scalars.push_back(static_cast<float>(random() % 1000) / 1000);
    return shape;
}

Frame written_over(const Shape& wall, const color::ColorScale& scale, bool light, int height) {
    Frame frame = annotated_frame(height * 16 / 9, height);
    const Frame straight = front_view(frame.width, frame.height);
    frame.camera = straight.camera;
    if (light) {
        frame.background_top = {1, 1, 1};
        frame.background_bottom = {0.9F, 0.92F, 0.95F};
    }
    Primitives primitives = wall.primitives();
    primitives.lit = false;
    primitives.scale = scale;
    frame.primitives = {primitives};
    return frame;
}

color::ColorScale between(color::Rgb8 low, color::Rgb8 high) {
    color::ColorScale scale;
    scale.points = {{0, low}, {1, high}};
    scale.steps = 2; // two colors, so that the picture has specks of each, a few pixels wide
    return scale;
}

TEST(Legibility, AnythingThatIsWrittenHasContrastToAnyPictureBehindIt) {
    const Shape shape = wall();
    constexpr color::Rgb8 white{255, 255, 255}, black{0, 0, 0}, gray{128, 128, 128};
    Renderer renderer(available_backends().front());
    fonts::Font font;
    Image image;
    double least = INFINITY;
    for (const auto& [name, scale] : {std::pair{"white", between(white, white)},
                                      {"black", between(black, black)},
                                      {"gray", between(gray, gray)},
                                      {"noise", between(black, white)}})
        for (const bool light : {false, true})
            for (const int height : {360, 720, 1440}) {
                const Frame frame = written_over(shape, scale, light, height);
                renderer.draw(frame, image);
                const annotations::Overlay overlay = annotations::lay_out(frame, font);
                ASSERT_GE(overlay.labels.size(), 12U);
                for (const annotations::Label& label : overlay.labels) {
                    // The triad's letters have the colors of their axes.
                    if (label.ink != overlay.labels.front().ink) continue;
                    const Seen seen = seen_of(label, font, image);
                    if (seen.letters.size() < 8) continue; // too few pixels: a minus sign or a comma
                    const double found = contrast(mean(seen.letters), mean(seen.around));
                    least = std::min(least, found);
                    EXPECT_GE(found, least_contrast)
                        << '"' << label.text << "\" over " << name << (light ? ", light " : ", dark ") << height;
                }
            }
    RecordProperty("least_contrast", std::to_string(least));
}

// Plates have the background's color, so they are invisible where nothing is drawn behind them.
TEST(Legibility, PlatesAreNotSeenWherePicturesAreEmpty) {
    Renderer renderer(available_backends().front());
    fonts::Font font;
    Image image;
    for (const bool light : {false, true}) {
        const Shape shape = wall();
        Frame frame = written_over(shape, {}, light, 360);
        frame.primitives.clear();
        renderer.draw(frame, image);
        const Image written = image;
        const annotations::Overlay overlay = annotations::lay_out(frame, font);
        ASSERT_FALSE(overlay.plates.empty());
        frame.annotations = {};
        renderer.draw(frame, image);
        const annotations::Plate& plate = overlay.plates.front();
        const auto row = static_cast<std::size_t>(plate.box.top); // row above the letters
        for (auto x = static_cast<std::size_t>(plate.box.left); x < static_cast<std::size_t>(plate.box.right); ++x)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t at = 3 * (row * static_cast<std::size_t>(image.width) + x) + k;
                EXPECT_NEAR(written.rgb[at], image.rgb[at], 1);
            }
    }
}

} // namespace
} // namespace server::annotations
