// Several volumes in one mesh: their light is blended by depth, independent of the order of the volumes.
#include "color/color_scale.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

#include <gmock/gmock.h>

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

constexpr color::Rgb8 white{255, 255, 255}, black{0, 0, 0};

const test::Polyhedra& cube() {
    static const test::Polyhedra primitives = test::zoo(Box{{4, 4, 4}, 0, 3, 0.25});
    return primitives;
}

struct Fog { // Fog of one color. Opacity per unit length at property 0 and at property 1.
    color::Rgb8 light;
    double opacity_at_0, opacity_at_1;

    [[nodiscard]] Volume made(Volume volume) const {
        volume.scale.points = {{0, light}, {1, light}};
        volume.scale.range = {0, 1};
        volume.opacity_points = {{0, opacity_at_0}, {1, opacity_at_1}};
        return volume;
    }
    [[nodiscard]] double extinction(double property) const {
        return -std::log(1 - (opacity_at_0 + (opacity_at_1 - opacity_at_0) * property));
    }
};

std::vector<Volume> in_order(const Volume& a, const Volume& b, bool swapped) {
    return swapped ? std::vector{b, a} : std::vector{a, b};
}

std::string name_of(const View& view, const Vec3d& normal, std::size_t slices) {
    return std::string(view.name) + ", " + std::to_string(slices) + " slices along " + testing::PrintToString(normal);
}

// The red channel shows the white volume's share of the scattered light. Rays almost parallel to the slabs lose much
// light within one slab.
TEST(ConstantVolumesTogether, FollowBeerAndLambertOfTheirSumInTheirMixedColor) {
    VolumeScene one(cube(), [](const Vec3d&) { return 1.0; }), other(cube(), [](const Vec3d&) { return 0.0; });
    const Fog bright{white, 0, 0.8}, dark{black, 0.9, 0};
    const double a = bright.extinction(1), b = dark.extinction(0);
    for (const View& view : views)
        for (const auto& [slices, others] : {std::array<std::size_t, 2>{120, 120}, {200, 150}})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)})
                for (const bool swapped : {false, true}) {
                    Frame frame = frame_of(view);
                    frame.volumes = in_order(bright.made(one.volume(normal, slices)),
                                             dark.made(other.volume(normal, others)), swapped);
                    const auto expected = [&](const Ray& ray) {
                        const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
                        return a / (a + b) * (1 - std::exp(-(a + b) * std::max(0.0, to - from)));
                    };
                    expect_close(compare(frame, expected, 0.02),
                                 name_of(view, normal, slices) + (swapped ? ", swapped" : ""));
                }
}

// Each slab takes a quarter of the light or more. The blending must still be even within the slabs.
TEST(DenseVolumesTogether, FollowBeerAndLambertOfTheirSumInTheirMixedColor) {
    VolumeScene one(cube(), [](const Vec3d&) { return 1.0; }), other(cube(), [](const Vec3d&) { return 0.0; });
    const Fog bright{white, 0.999, 0.999}, dark{black, 0.998, 0.998};
    const double a = bright.extinction(1), b = dark.extinction(0);
    for (const View& view : views)
        for (const auto& [slices, others] : {std::array<std::size_t, 2>{40, 40}, {60, 45}})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)})
                for (const bool swapped : {false, true}) {
                    // For some rays along the slabs, most light comes from half a slab at the side of the cube.
                    if (view.fov > 70 && view.distance > 1 && slices != others) continue;
                    Frame frame = frame_of(view);
                    frame.volumes = in_order(bright.made(one.volume(normal, slices)),
                                             dark.made(other.volume(normal, others)), swapped);
                    const auto expected = [&](const Ray& ray) {
                        const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
                        return a / (a + b) * (1 - std::exp(-(a + b) * std::max(0.0, to - from)));
                    };
                    expect_close(compare(frame, expected, 0.015),
                                 name_of(view, normal, slices) + (swapped ? ", swapped" : ""));
                }
}

double integral(const Ray& ray, const std::function<std::array<double, 2>(const Vec3d&)>& bright_and_dark) {
    const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
    constexpr int steps = 300;
    const double length = (to - from) / steps;
    double light = 0, left = 1;
    for (int i = 0; i < steps && to > from; ++i) {
        const auto [a, b] = bright_and_dark(plus(ray[0], ray[1], from + (i + 0.5) * length));
        const double passed = std::exp(-(a + b) * length);
        light += left * (1 - passed) * a / (a + b);
        left *= passed;
    }
    return light;
}

double rising(const Vec3d& p) { return 0.5 * p[0] + 0.2 * p[1] + 0.3 * p[2]; }
double falling(const Vec3d& p) { return 1 - p[1]; }

// The two volumes overlap everywhere. Which one dominates in front depends on the view.
TEST(LinearVolumesTogether, HaveTheIntegralsLight) {
    VolumeScene one(cube(), rising), other(cube(), falling);
    const Fog bright{white, 0.1, 0.95}, dark{black, 0, 0.95};
    for (const View& view : views)
        for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)})
            for (const bool swapped : {false, true}) {
                constexpr std::size_t slices = 100;
                Frame frame = frame_of(view);
                frame.volumes =
                    in_order(bright.made(one.volume(normal, slices)), dark.made(other.volume(normal, slices)), swapped);
                const auto expected = [&](const Ray& ray) {
                    return integral(ray, [&](const Vec3d& p) {
                        return std::array{bright.extinction(rising(p)), dark.extinction(falling(p))};
                    });
                };
                expect_close(compare(frame, expected, 0.02),
                             name_of(view, normal, slices) + (swapped ? ", swapped" : ""));
            }
}

// A single slab hides most of the light. Slabs of two volumes at the same place must therefore alternate.
TEST(VolumesTogether, DoNotDependOnTheirOrderFromSixSides) {
    VolumeScene one(cube(), rising), other(cube(), falling);
    const Fog bright{white, 0.1, 0.999}, dark{{0, 0, 255}, 0.6, 0.99};
    for (const Vec3d& from :
         {Vec3d{1, 0.3, 0.2}, {-1, 0.3, 0.2}, {0.3, 1, 0.2}, {0.3, -1, 0.2}, {0.2, 0.3, 1}, {0.2, 0.3, -1}})
        for (const bool shaded : {false, true}) {
            const View view{"", from, 30};
            Frame frame = frame_of(view);
            Volume a = bright.made(one.volume(nearest_axis(from), 40));
            const Volume b = dark.made(other.volume(nearest_axis(from), 40));
            a.shaded = shaded;
            std::array<Image, 2> images;
            for (const bool swapped : {false, true}) {
                frame.volumes = in_order(a, b, swapped);
                renderer().draw(frame, images[swapped ? 1 : 0]);
            }
            double sum = 0, brightness = 0;
            for (std::size_t i = 0; i < images[0].rgb.size(); ++i) {
                const int off = std::abs(images[0].rgb[i] - images[1].rgb[i]);
                EXPECT_LE(off, 4) << testing::PrintToString(from) << " at " << i / 3 % side << ", " << i / 3 / side;
                sum += off;
                brightness += images[0].rgb[i];
            }
            EXPECT_LT(sum, 0.01 * brightness) << testing::PrintToString(from);
        }
}

TEST(VolumesTogether, KeepTheirBrightnessWhileSomethingMoves) {
    VolumeScene one(cube(), rising), other(cube(), falling);
    const Fog bright{white, 0, 0.9}, dark{black, 0.2, 0.9};
    for (const View& view : {views[1], views[4], views[7]}) {
        std::vector<double> brightness;
        for (const std::size_t stride : {1, 5}) {
            Frame frame = frame_of(view);
            frame.volumes = {bright.made(one.volume(nearest_axis(view.from), 100)),
                             dark.made(other.volume(nearest_axis(view.from), 80))};
            for (Volume& volume : frame.volumes) {
                volume.stride = stride;
                volume.coarseness = stride > 1 ? 2 : 1;
            }
            Image image;
            renderer().draw(frame, image);
            double sum = 0;
            for (const std::uint8_t channel : image.rgb) sum += channel;
            brightness.push_back(sum);
        }
        EXPECT_NEAR(brightness[1] / brightness[0], 1, 0.01) << view.name;
    }
}

// A surface inside both volumes, and a plane that cuts both.
TEST(VolumesTogether, EndOnSurfacesAndPlanes) {
    VolumeScene one(cube(), [](const Vec3d&) { return 1.0; }), other(cube(), [](const Vec3d&) { return 0.0; });
    const Fog bright{white, 0, 0.8}, dark{black, 0.9, 0};
    const double a = bright.extinction(1), b = dark.extinction(0);
    const Shape wall = square(0.613);
    const View view{"", {0.1, -1, 0.2}, 30};
    Frame frame = frame_of(view, {-1, 0, -1}, {1, 1, 1});
    frame.camera.target = {0.5, 0.5, 0.5};
    frame.camera.position = plus(frame.camera.target, unit_of(view.from), view.distance);
    Primitives primitives = wall.primitives();
    primitives.scalars = {};
    primitives.color = {0, 0, 0, 1};
    primitives.lit = false;
    frame.primitives.push_back(primitives);
    frame.clip = {{0, 1, 0, -0.2F}};
    frame.volumes = {bright.made(one.volume({0, 1, 0}, 90)), dark.made(other.volume({0, 1, 0}, 90))};
    expect_close(compare(
                     frame,
                     [&](const Ray& ray) {
                         auto [from, to] = inside_box(ray, {0, 0.2, 0}, {1, 1, 1});
                         const double wall_at = (0.613 - ray[0][1]) / ray[1][1];
                         const Vec3d hit = plus(ray[0], ray[1], wall_at);
                         if (std::abs(hit[0]) < 1 && std::abs(hit[2]) < 1) to = std::min(to, wall_at);
                         return a / (a + b) * (1 - std::exp(-(a + b) * std::max(0.0, to - from)));
                     },
                     0.015),
                 "a wall and a plane");
}

TEST(VolumesTogether, AreFadedByTheLargestOpacityAndThinnedByTheirOwn) {
    VolumeScene one(cube(), [](const Vec3d&) { return 1.0; }), other(cube(), [](const Vec3d&) { return 0.0; });
    const Fog bright{white, 0, 0.8}, dark{black, 0.9, 0};
    const View view = views[4];
    for (const auto& [of_one, of_other] : {std::array<float, 2>{0.5F, 0.5F}, {0.5F, 1}, {0.8F, 0.2F}, {0.6F, 0}}) {
        Frame frame = frame_of(view);
        frame.volumes = {bright.made(one.volume(nearest_axis(view.from), 100)),
                         dark.made(other.volume(nearest_axis(view.from), 100))};
        frame.volumes[0].opacity = of_one;
        frame.volumes[1].opacity = of_other;
        const double most = std::max(of_one, of_other);
        const double a = -std::log(1 - 0.8 * of_one / most), b = -std::log(1 - 0.9 * of_other / most);
        const auto expected = [&](const Ray& ray) {
            const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
            return most * a / (a + b) * (1 - std::exp(-(a + b) * std::max(0.0, to - from)));
        };
        expect_close(compare(frame, expected, 0.015), std::to_string(of_one) + " and " + std::to_string(of_other));
    }
}

// The second volume's mesh covers half of the first one's. Outside of it only the first volume counts.
TEST(VolumesTogether, MayHaveDifferentBoundaries) {
    VolumeScene whole(cube(), [](const Vec3d&) { return 1.0; });
    VolumeScene half(test::hexahedra(Box{{2, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 0.0; });
    const Fog bright{white, 0, 0.8}, dark{black, 0.9, 0};
    const double a = bright.extinction(1), b = dark.extinction(0);
    for (const bool swapped : {false, true}) {
        Frame frame = frame_of({"", {0.3, -1, 0.2}, 30});
        frame.volumes =
            in_order(bright.made(whole.volume({0, 1, 0}, 100)), dark.made(half.volume({0, 1, 0}, 100)), swapped);
        const auto expected = [&](const Ray& ray) {
            const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
            const auto [from_half, to_half] = inside_box(ray, {0, 0, 0}, {0.5, 1, 1});
            if (from >= to) return 0.0;
            const auto light = [](double share, double tau, double length) {
                return share * (1 - std::exp(-tau * length));
            };
            if (from_half >= to_half) return light(1, a, to - from);
            const double before = from_half - from, mixed = to_half - from_half, after = to - to_half;
            return light(1, a, before) + std::exp(-a * before) * (light(a / (a + b), a + b, mixed) +
                                                                  std::exp(-(a + b) * mixed) * light(1, a, after));
        };
        expect_close(compare(frame, expected, 0.02), swapped ? "swapped" : "");
    }
}

// The line is in front of one volume and behind the other, in both orders of the volumes.
TEST(VolumesTogether, HideALineThatIsBehindOneOfThem) {
    const auto layer = [](test::Id row) {
        return test::keep_cells(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}),
                                [=](test::Id cell) { return cell / 4 % 4 == row; });
    };
    VolumeScene near(layer(0), [](const Vec3d&) { return 1.0; }), far(layer(3), [](const Vec3d&) { return 1.0; });
    const std::vector<Vec3f> ends{{-1, 0.5F, 0.5F}, {2, 0.5F, 0.5F}};
    for (const bool swapped : {false, true}) {
        Frame frame = frame_of(views[0]);
        for (VolumeScene* scene : {&near, &far}) {
            Volume volume = Fog{white, 1, 1}.made(scene->volume({0, 1, 0}, 20));
            volume.unit_length = 0.002;
            frame.volumes.push_back(volume);
        }
        if (swapped) std::swap(frame.volumes[0], frame.volumes[1]);
        frame.primitives = {line_between(ends, 6, {1, 0, 0, 1})};
        Image image;
        renderer().draw(frame, image);
        const auto at = [&](int x, int y) { return &image.rgb[3 * static_cast<std::size_t>(y * side + x)]; };
        EXPECT_GT(at(side / 2, side / 2)[1], 240) << "the line is seen through the volume in front of it";
        EXPECT_LT(at(5, side / 2)[1], 10);
        EXPECT_GT(at(5, side / 2)[0], 240) << "beside the volumes there is the line";
    }
}

TEST(VolumesTogether, NeedOneDirection) {
    VolumeScene one(cube(), rising), other(cube(), falling);
    Frame frame = frame_of(views[0]);
    frame.volumes = {one.volume({0, 1, 0}, 4), other.volume({1, 0, 0}, 4)};
    Image image;
    EXPECT_THAT([&] { renderer().draw(frame, image); },
                testing::ThrowsMessage<Error>(testing::HasSubstr("sliced in different directions")));
}

} // namespace
} // namespace server::render
