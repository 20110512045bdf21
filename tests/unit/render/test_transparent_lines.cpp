// Segments of one transparent line layer that meet at a pixel are blended once. Line layers are blended in depth order.
#include "backends.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

using Color = std::array<float, 4>;

struct Lines {
    std::vector<Vec3f> positions;
    std::vector<Index> indices;

    [[nodiscard]] Primitives primitives(float width, Color color) const {
        Primitives primitives;
        primitives.positions = positions;
        primitives.indices = indices;
        primitives.lines = true;
        primitives.line_width = width;
        primitives.color = color;
        return primitives;
    }
    [[nodiscard]] Lines backwards() const {
        Lines other{positions, {indices.rbegin(), indices.rend()}};
        return other;
    }
};

// `depth(x, z)` gives y.
template <typename Depth>
Lines zigzag(Depth depth) {
    Lines lines;
    for (Index i = 0; i <= 24; ++i) {
        const float x = -1.2F + 0.1F * static_cast<float>(i), z = i % 2 == 0 ? -0.06F : 0.3F * std::sin(3 * x);
        lines.positions.push_back({x, static_cast<float>(depth(x, z)), z});
        if (i > 0) lines.indices.insert(lines.indices.end(), {i - 1, i});
    }
    return lines;
}

// All triangle edges of a mesh: up to six meet at a vertex, and each inner edge occurs twice.
template <typename Depth>
Lines wires(Depth depth) {
    const Shape shape = grid(6, 5, [&](double u, double v) {
        const double x = 2 * u - 1 + 0.07 * std::sin(7 * v), z = 1.6 * v - 0.8;
        return Vec3f{static_cast<float>(x), static_cast<float>(depth(x, z)), static_cast<float>(z)};
    });
    Lines lines{shape.positions, {}};
    for (std::size_t i = 0; i < shape.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            lines.indices.push_back(shape.indices[i + k]);
            lines.indices.push_back(shape.indices[i + (k + 1) % 3]);
        }
    return lines;
}

class TransparentLines : public testing::TestWithParam<Backend> {
protected:
    TransparentLines() {
        frame.background_top = frame.background_bottom = {0, 0, 0};
        frame.bounds_min = {-2, -6, -2};
        frame.bounds_max = {2, 6, 2};
        frame.camera.position = {0, -20, 0};
    }
    void draw() { renderer.draw(frame, image); }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const {
        return &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
    }
    // Distance in pixels from a pixel's center to the nearest segment.
    [[nodiscard]] double distance(const Lines& lines, int x, int y) const {
        double least = 1e9;
        const double pixels = image.height / frame.camera.parallel_height;
        const auto place = [&](Index vertex) {
            const Vec3f& p = lines.positions[vertex];
            return std::array<double, 2>{image.width / 2.0 + pixels * p[0], image.height / 2.0 - pixels * p[2]};
        };
        for (std::size_t i = 0; i < lines.indices.size(); i += 2) {
            const auto a = place(lines.indices[i]), b = place(lines.indices[i + 1]);
            const double u = b[0] - a[0], v = b[1] - a[1], right = x + 0.5 - a[0], down = y + 0.5 - a[1];
            const double along = std::clamp((right * u + down * v) / (u * u + v * v), 0.0, 1.0);
            least = std::min(least, std::hypot(right - along * u, down - along * v));
        }
        return least;
    }
    // Expects `color` in all pixels along the middle of the lines, joints included.
    void expect_even(const Lines& lines, float width, const std::array<double, 3>& color, const std::string& what,
                     double most = 2) {
        int pixels = 0, off = 0, worst = 0, worst_x = 0, worst_y = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                // The range in which line ends have full coverage too.
                if (distance(lines, x, y) > width / 4 - 0.25) continue;
                ++pixels;
                for (std::size_t k = 0; k < 3; ++k) {
                    const int difference = static_cast<int>(std::lround(at(x, y)[k] - 255 * color[k]));
                    if (std::abs(difference) > most) ++off;
                    if (std::abs(difference) <= std::abs(worst)) continue;
                    worst = difference;
                    worst_x = x;
                    worst_y = y;
                }
            }
        EXPECT_GT(pixels, 300) << what;
        EXPECT_EQ(off, 0) << what << ": most of all by " << worst << " of 255 at " << worst_x << ", " << worst_y;
    }

    Renderer renderer{GetParam()};
    Frame frame = front_view();
    Image image;
};

INSTANTIATE_TEST_SUITE_P(Backends, TransparentLines, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(TransparentLines);

const auto flat = [](double, double) { return 0.0; };
const auto leaning = [](double x, double z) { return 2 * x + 3 * z; };
const auto bent = [](double x, double z) { return 2 * std::abs(x) + z * z; };

TEST_P(TransparentLines, AreEvenAlongTheirMiddleAndInTheirJoints) {
    for (const int samples : {1, 4})
        for (const float width : {3.0F, 5.0F}) {
            int row = 0;
            for (const Lines& lines : {zigzag(flat), zigzag(leaning), zigzag(bent), wires(flat), wires(leaning),
                                       wires(bent), zigzag(bent).backwards(), wires(bent).backwards()}) {
                frame.samples = samples;
                frame.primitives = {lines.primitives(width, {1, 0.5F, 0, 0.4F})};
                draw();
                expect_even(lines, width, {0.4, 0.2, 0},
                            std::to_string(samples) + " samples, " + std::to_string(width) + " pixels wide, lines " +
                                std::to_string(row++));
            }
        }
}

// The lines lie on a mesh, opaque or transparent.
TEST_P(TransparentLines, AreEvenOnASurface) {
    for (const float opacity : {1.0F, 0.5F})
        for (const int samples : {1, 4}) {
            const Lines lines = wires(leaning);
            const Shape sheet = grid(1, 1, [](double u, double v) {
                const double x = 3 * u - 1.5, z = 2 * v - 1;
                return Vec3f{static_cast<float>(x), static_cast<float>(leaning(x, z)), static_cast<float>(z)};
            });
            Primitives surface = sheet.primitives();
            surface.lit = false;
            surface.color = {0, 0, 1, opacity};
            frame.samples = samples;
            frame.primitives = {surface, lines.primitives(3, {1, 1, 0, 0.5F})};
            draw();
            expect_even(lines, 3, {0.5, 0.5, 0.5 * opacity},
                        std::to_string(samples) + " samples, a sheet of " + std::to_string(opacity));
        }
}

struct Tube {
    double tilt = 0;
    double turn = 0;  // rotation in sides of the tube; at 0.5 one side is parallel to the view
    double aside = 0; // x coordinate of the tube's axis

    [[nodiscard]] Shape shape() const {
        constexpr Index columns = 24;
        return grid(columns, 10, [this](double u, double v) {
            const double angle = 2 * std::numbers::pi * (u + turn / columns), z = 1.6 * v - 0.8;
            return Vec3f{static_cast<float>(0.5 * std::cos(angle) + tilt * z + aside),
                         static_cast<float>(0.5 * std::sin(angle)), static_cast<float>(z)};
        });
    }
};

// Two sides of each quadrilateral of a grid.
Lines sides_of(const Shape& shape) {
    Lines lines{shape.positions, {}};
    for (std::size_t i = 0; i < shape.indices.size(); i += 6)
        for (const std::size_t other : {i + 1, i + 5})
            lines.indices.insert(lines.indices.end(), {shape.indices[i], shape.indices[other]});
    return lines;
}

std::vector<Tube> steep_tubes() {
    std::vector<Tube> tubes;
    for (const double tilt : {0.0, 0.05, 0.15, 0.4})
        for (const double turn : {0.5, 0.495, 0.48, 0.0})
            for (const double aside : {0.0, -0.003, -0.006, -0.009}) tubes.push_back({tilt, turn, aside});
    return tubes;
}

// Lines on a steep sheet are drawn far in front of it, but must stay behind a pane well in front of the sheet.
TEST_P(TransparentLines, OnSteepSheetsStayBehindAPane) {
    const Shape in_front = square(-1.2);
    Primitives pane = in_front.primitives();
    pane.scalars = {};
    pane.lit = false;
    pane.color = {0, 0, 1, 0.5F};
    for (const Tube& tube : steep_tubes()) {
        const Shape shape = tube.shape();
        const Lines lines = sides_of(shape);
        Primitives sheet = shape.primitives();
        sheet.lit = false;
        sheet.color = {0, 1, 0, 0.5F};
        frame.primitives = {sheet, lines.primitives(3, {1, 0, 0, 1})};
        draw();
        const Image without = image;
        frame.primitives.push_back(pane);
        draw();
        int seen = 0, off = 0;
        for (int y = 45; y < 195; ++y)
            for (int x = 85; x < 235; ++x) {
                const std::size_t red = 3 * static_cast<std::size_t>(y * image.width + x);
                seen += without.rgb[red] > 100 ? 1 : 0;
                off += std::abs(image.rgb[red] - without.rgb[red] / 2) > 3 ? 1 : 0;
            }
        EXPECT_GT(seen, 3000);
        EXPECT_EQ(off, 0) << "tilted by " << tube.tilt << ", turned by " << tube.turn << ", " << tube.aside << " aside";
    }
}

// A steep transparent sheet just in front of lines on an opaque wall. The lines must look as behind a flat pane, not as
// lines on the sheet.
TEST_P(TransparentLines, OnOpaqueSurfacesStayBehindSteepSheets) {
    const auto wall_at = [](double x, double) { return 0.3 * x; };
    const Lines lines = wires(wall_at);
    const auto sheet_at = [](const auto& depth) {
        return grid(2, 8, [&](double u, double v) {
            const double x = 2.4 * u - 1.2, z = 2 * v - 1;
            return Vec3f{static_cast<float>(x), static_cast<float>(depth(x, z)), static_cast<float>(z)};
        });
    };
    const Shape wall = sheet_at(wall_at), pane = sheet_at([](double, double) { return -3.0; });
    Primitives opaque = wall.primitives();
    opaque.lit = false;
    opaque.color = {0, 1, 0, 1};
    const auto seen_through = [&](const Shape& shape) {
        Primitives sheet = shape.primitives();
        sheet.lit = false;
        sheet.color = {0, 0, 1, 0.5F};
        frame.primitives = {opaque, lines.primitives(3, {1, 0, 0, 1}), sheet};
        frame.primitives[1].on_opaque = true;
        draw();
        return image;
    };
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        const Image expected = seen_through(pane);
        for (const double steep : {0.5, 2.0, 4.0}) {
            const Image found =
                seen_through(sheet_at([&](double x, double z) { return wall_at(x, z) - 0.02 - steep * std::abs(x); }));
            int off = 0;
            for (std::size_t i = 0; i < found.rgb.size(); ++i)
                off += std::abs(found.rgb[i] - expected.rgb[i]) > 2 ? 1 : 0;
            EXPECT_EQ(off, 0) << "a slope of " << steep << ", " << samples << " samples";
        }
    }
}

// The red layer is nearer. The order of the layers in the document has no effect.
TEST_P(TransparentLines, OfTwoLayersAreMixedInTheirOrder) {
    const Lines near{{{-1, -0.5F, 0}, {1, -0.5F, 0}}, {0, 1}}, far{{{0, 0.5F, -1}, {0, 0.5F, 1}}, {0, 1}};
    for (const int samples : {1, 4})
        for (const bool near_first : {true, false}) {
            frame.samples = samples;
            frame.primitives = {near.primitives(8, {1, 0, 0, 0.6F}), far.primitives(8, {0, 1, 0, 0.6F})};
            if (!near_first) std::swap(frame.primitives[0], frame.primitives[1]);
            draw();
            EXPECT_NEAR(at(160, 120)[0], 0.6 * 255, 2);
            EXPECT_NEAR(at(160, 120)[1], 0.4 * 0.6 * 255, 2);
        }
}

// Two lines of one layer that cross far apart in depth are blended twice.
TEST_P(TransparentLines, OfOneLayerAreSeenThroughEachOther) {
    const Lines both{{{-1, -0.5F, 0}, {1, -0.5F, 0}, {0, 0.5F, -1}, {0, 0.5F, 1}}, {0, 1, 2, 3}};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        frame.primitives = {both.primitives(8, {1, 0, 0, 0.5F})};
        draw();
        EXPECT_NEAR(at(160, 120)[0], 0.75 * 255, 2);
        EXPECT_NEAR(at(130, 120)[0], 0.5 * 255, 2);
    }
}

TEST_P(TransparentLines, AreMixedWithSheetsAndOpaqueLines) {
    const Lines front{{{-1, -0.5F, 0}, {0, -0.5F, 0}, {1, -0.5F, 0}}, {0, 1, 1, 2}};
    const Lines back{{{-1, 0.5F, 0}, {1, 0.5F, 0}}, {0, 1}};
    const Shape shape = square(0);
    Primitives sheet = shape.primitives();
    sheet.scalars = {};
    sheet.lit = false;
    sheet.color = {0, 1, 0, 0.5F};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        frame.primitives = {back.primitives(12, {0, 0, 1, 1}), sheet, front.primitives(6, {1, 0, 0, 0.5F})};
        draw();
        EXPECT_NEAR(at(160, 120)[0], 0.5 * 255, 2);
        EXPECT_NEAR(at(160, 120)[1], 0.25 * 255, 2);
        EXPECT_NEAR(at(160, 120)[2], 0.25 * 255, 2);
        EXPECT_NEAR(at(160, 115)[2], 0.5 * 255, 2) << "beside the nearer line";
    }
}

// Lines in front of the fog are blended once, not once in front of it and once behind.
TEST_P(TransparentLines, InFrontOfAVolumeAreSeenOnce) {
    VolumeScene fog(test::hexahedra({{2, 2, 2}}), [](const Vec3d&) { return 1.0; });
    Volume volume = fog.volume({0, 1, 0}, 40);
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0.5}, {1, 0.5}};
    volume.unit_length = 2;
    frame.volumes = {volume};
    frame.bounds_min = {0, -1, 0};
    frame.bounds_max = {2, 2, 2};
    frame.camera.position = {1, -9, 1};
    frame.camera.target = {1, 1, 1};
    const Lines line{{{0, -0.5F, 1}, {1, -0.5F, 1}, {2, -0.5F, 1}}, {0, 1, 1, 2}};
    frame.primitives = {line.primitives(6, {1, 0, 0, 0.5F})};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        draw();
        EXPECT_NEAR(at(160, 120)[0], 0.75 * 255, 3);
        EXPECT_NEAR(at(160, 120)[1], 0.25 * 255, 3);
    }
}

TEST_P(TransparentLines, AreFoundByAPointer) {
    const Lines line{{{-1, 0.25F, 0}, {1, 0.25F, 0}}, {0, 1}};
    frame.primitives = {line.primitives(6, {1, 0, 0, 0.5F})};
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        draw();
        Vec3d found{};
        ASSERT_TRUE(renderer.pick(150, 120, found));
        EXPECT_NEAR(found[1], 0.25, 1e-3);
        EXPECT_FALSE(renderer.pick(150, 60, found));
    }
}

} // namespace
} // namespace server::render
