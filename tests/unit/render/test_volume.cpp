// Volumes against closed forms: Beer-Lambert for a constant property, the integral for a linear one.
#include "color/transfer_table.hpp"
#include "scenes.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tuple>

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

struct Solid {
    const char* name;
    test::Polyhedra (*make)();
    std::vector<std::array<Vec3d, 2>> boxes; // boxes that the solid fills
    std::vector<std::array<Vec3d, 2>> holes; // holes in the boxes

    [[nodiscard]] double length(const Ray& ray) const {
        double sum = 0;
        for (const auto& [low, high] : boxes) sum += positive(inside_box(ray, low, high));
        for (const auto& [low, high] : holes) sum -= positive(inside_box(ray, low, high));
        return sum;
    }
    friend std::ostream& operator<<(std::ostream& out, const Solid& solid) { return out << solid.name; }

private:
    static double positive(const std::array<double, 2>& span) { return std::max(0.0, span[1] - span[0]); }
};

test::Polyhedra cube_without(int n, const std::function<bool(std::array<int, 3>)>& hole) {
    const test::Polyhedra whole = test::hexahedra(Box{{n, n, n}, 0, 1, 1.0 / n});
    return test::keep_cells(whole, [&](test::Id cell) {
        const int i = static_cast<int>(cell);
        return !hole({i % n, i / n % n, i / (n * n)});
    });
}

bool inner(int i) { return i == 1 || i == 2; }

const std::vector<std::array<Vec3d, 2>> unit_cube{{Vec3d{0, 0, 0}, Vec3d{1, 1, 1}}};
const std::vector<Solid> solids{
    {"hexahedra",
     [] {
         return test::hexahedra(Box{{3, 4, 5}, 0, 1, 0.2});
     },
     {{Vec3d{}, Vec3d{0.6, 0.8, 1}}},
     {}},
    {"zoo",
     [] {
         return test::zoo(Box{{4, 4, 4}, 0, 3, 0.25});
     },
     unit_cube,
     {}},
    {"voronoi", [] { return test::voronoi(200, 5); }, unit_cube, {}},
    {"one_giant_cell_and_a_layer", [] { return test::giant_cell(4); }, {}, {}},
    {"void",
     [] { return cube_without(4, [](auto c) { return inner(c[0]) && inner(c[1]) && inner(c[2]); }); },
     unit_cube,
     {{Vec3d{0.25, 0.25, 0.25}, Vec3d{0.75, 0.75, 0.75}}}},
    {"groove",
     [] { return cube_without(4, [](auto c) { return c[1] == 1 || (c[1] == 2 && c[2] > 1); }); },
     unit_cube,
     {{Vec3d{0, 0.25, 0}, Vec3d{1, 0.5, 1}}, {Vec3d{0, 0.5, 0.5}, Vec3d{1, 0.75, 1}}}},
    {"comb", // a ray across the comb passes through eight teeth
     [] { return cube_without(15, [](auto c) { return c[1] % 2 == 1; }); }, unit_cube,
     [] {
         std::vector<std::array<Vec3d, 2>> gaps;
         for (int i = 1; i < 15; i += 2) gaps.push_back({Vec3d{0, i / 15.0, 0}, Vec3d{1, (i + 1) / 15.0, 1}});
         return gaps;
     }()},
    {"inner_wall", // two parts that touch without shared vertices: a double wall in the middle
     [] {
         const auto half = test::hexahedra(Box{{2, 4, 4}, 0, 1, 0.25});
         return test::joined(half, half, {0.5, 0, 0});
     },
     unit_cube,
     {}},
};

class ConstantVolumes : public testing::TestWithParam<Solid> {};

INSTANTIATE_TEST_SUITE_P(Solids, ConstantVolumes, testing::ValuesIn(solids),
                         [](const auto& solid) { return std::string(solid.param.name); });

constexpr double opacity = 0.8; // opacity of one unit of length

TEST_P(ConstantVolumes, FollowsBeerAndLambertFromAnywhere) {
    Solid solid = GetParam();
    const test::Polyhedra primitives = solid.make();
    if (solid.boxes.empty()) { // uses the mesh's bounding box
        std::array<Vec3d, 2> box{primitives.position(0), primitives.position(0)};
        for (test::Id v = 0; v < primitives.vertex_count(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box[0][axis] = std::min(box[0][axis], primitives.position(v)[axis]);
                box[1][axis] = std::max(box[1][axis], primitives.position(v)[axis]);
            }
        solid.boxes.push_back(box);
    }
    VolumeScene scene(primitives, [](const Vec3d&) { return 1.0; });
    for (const View& view : views)
        for (const std::size_t slices : {50, 333})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
                Frame frame = frame_of(view, solid.boxes[0][0], solid.boxes[0][1]);
                frame.volumes.push_back(scene.volume(normal, slices));
                frame.volumes[0].scale.range = {0, 1};
                frame.volumes[0].opacity_points = {{0, opacity}};
                const auto expected = [&](const Ray& ray) { return 1 - std::pow(1 - opacity, solid.length(ray)); };
                expect_close(compare(frame, expected, 0.01), std::string(view.name) + ", " + std::to_string(slices) +
                                                                 " slices along " + testing::PrintToString(normal));
            }
}

// Volumes are accumulated in floats: a thin slab here changes a byte by only 0.33.
TEST(ConstantVolume, IsLostInBytesWhereSlabsAreThinAndBackInFloats) {
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; });
    Frame frame = frame_of(views[0]);
    frame.volumes.push_back(scene.volume({0, 1, 0}, 400));
    frame.volumes[0].scale.range = {0, 1};
    frame.volumes[0].opacity_points = {{0, 0.4}};
    const auto brightest = [&](bool in_bytes) {
        frame.volumes[0].in_bytes = in_bytes;
        Image image;
        renderer().draw(frame, image);
        return static_cast<int>(*std::ranges::max_element(image.rgb));
    };
    const int in_floats = brightest(false);
    EXPECT_NEAR(in_floats, 0.4 * 255, 2);
    EXPECT_EQ(brightest(true), 0);
    EXPECT_EQ(brightest(false), in_floats);
}

// Entry and exit are stored for eight parts of a ray. Later parts use whole slices, so only their ends are wrong.
TEST(ConstantVolume, IsAlmostRightWhereARayIsInItMoreThanEightTimes) {
    constexpr int rows = 31;
    VolumeScene scene(test::keep_cells(test::hexahedra(Box{{4, rows, 4}, 0, 1, 1}),
                                       [](test::Id cell) { return cell / 4 % rows % 2 == 0; }),
                      [](const Vec3d&) { return 1.0; });
    for (const View& view : {views[0], views[1], views[4]}) {
        Frame frame = frame_of({view.name, view.from, view.fov, 40}, {0, 0, 0}, {4, rows, 4});
        frame.camera.parallel_height = 12;
        frame.volumes.push_back(scene.volume({0, 1, 0}, 400));
        frame.volumes[0].scale.range = {0, 1};
        frame.volumes[0].opacity_points = {{0, 0.05}};
        const auto expected = [&](const Ray& ray) {
            double length = 0;
            for (int i = 0; i < rows; i += 2) {
                const auto [from, to] = inside_box(ray, {0, double(i), 0}, {4, i + 1.0, 4});
                length += std::max(0.0, to - from);
            }
            return 1 - std::pow(0.95, length);
        };
        const Difference difference = compare(frame, expected, 0.03);
        EXPECT_GT(difference.pixels, side * side / 40) << view.name;
        EXPECT_LE(difference.beyond, difference.pixels / 500) << view.name;
    }
}

// Light that a ray collects inside the unit cube, by numerical integration in 500 steps. The function returns color
// and extinction at a point.
double integral(const Ray& ray, const std::function<std::array<double, 2>(const Vec3d&)>& color_and_extinction) {
    const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
    constexpr int steps = 500;
    const double length = (to - from) / steps;
    double light = 0, left = 1;
    for (int i = 0; i < steps && to > from; ++i) {
        const auto [color, extinction] = color_and_extinction(plus(ray[0], ray[1], from + (i + 0.5) * length));
        const double passed = std::exp(-extinction * length);
        light += left * (1 - passed) * color;
        left *= passed;
    }
    return light;
}

double ramp(const Vec3d& p) { return 0.5 * p[0] + 0.2 * p[1] + 0.3 * p[2]; }

TEST(LinearVolume, HasTheIntegralsLightWithinTwoPerCent) {
    VolumeScene scene(test::zoo(Box{{4, 4, 4}, 0.1, 3, 0.25}), ramp);
    for (const View& view : views)
        for (const std::size_t slices : {50, 400})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
                Frame frame = frame_of(view);
                frame.volumes.push_back(scene.volume(normal, slices));
                frame.volumes[0].scale.range = {0, 1};
                frame.volumes[0].opacity_points = {{0, 0.1}, {1, 0.9}};
                const auto expected = [](const Ray& ray) {
                    return integral(ray, [](const Vec3d& p) {
                        return std::array<double, 2>{ramp(p), -std::log(1 - (0.1 + 0.8 * ramp(p)))};
                    });
                };
                expect_close(compare(frame, expected, 0.02), std::string(view.name) + ", " + std::to_string(slices) +
                                                                 " slices along " + testing::PrintToString(normal));
            }
}

TEST(LinearVolume, DoesNotChangeItsBrightnessWithTheSlicesTheAxisOrAStrideWhileMoving) {
    VolumeScene scene(test::voronoi(100, 7), ramp);
    for (const View& view : {views[1], views[4], views[7]}) {
        std::vector<double> brightness;
        for (const auto& [normal, slices, stride] : {std::tuple<Vec3d, std::size_t, std::size_t>{{0, 1, 0}, 100, 1},
                                                     {{0, 1, 0}, 100, 5},
                                                     {{0, 1, 0}, 53, 3},
                                                     {{1, 0, 0}, 100, 1},
                                                     {{0, 0, 1}, 400, 1},
                                                     {unit_of(view.from), 100, 1}}) {
            Frame frame = frame_of(view);
            frame.volumes.push_back(scene.volume(normal, slices));
            frame.volumes[0].stride = stride;
            frame.volumes[0].coarseness = stride > 1 ? 2 : 1;
            frame.volumes[0].scale.range = {0, 1};
            frame.volumes[0].opacity_points = {{0, 0}, {0.5, 0.1}, {0.6, 0.9}, {1, 0.9}};
            Image image;
            renderer().draw(frame, image);
            double sum = 0;
            for (const std::uint8_t channel : image.rgb) sum += channel;
            brightness.push_back(sum);
        }
        for (const double sum : brightness) EXPECT_NEAR(sum / brightness[0], 1, 0.01) << view.name;
    }
}

// Coordinates from the size of a nucleus to that of a galaxy, in meters. Squares of these lengths overflow or underflow
// float32.
TEST(LinearVolume, LooksTheSameInAnyUnit) {
    const auto picture = [](const View& view, const Vec3d& normal, double metre) {
        VolumeScene scene(test::zoo(Box{{4, 4, 4}, 0, 3, 0.25 * metre}), [&](const Vec3d& p) {
            return ramp({p[0] / metre, p[1] / metre, p[2] / metre});
        });
        Frame frame = frame_of(view);
        for (Vec3d* place : {&frame.bounds_min, &frame.bounds_max, &frame.camera.position, &frame.camera.target})
            for (double& coordinate : *place) coordinate *= metre;
        frame.camera.parallel_height *= metre;
        frame.volumes.push_back(scene.volume(normal, 100));
        frame.volumes[0].scale.range = {0, 1};
        frame.volumes[0].unit_length = 0.3 * metre;
        frame.volumes[0].shaded = true;
        Image image;
        renderer().draw(frame, image);
        return image.rgb;
    };
    for (const View& view : views)
        for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
            const auto expected = picture(view, normal, 1);
            EXPECT_GT(std::ranges::max(expected), 100) << view.name;
            for (const double metre : {1e-22, 1e22}) {
                const auto drawn = picture(view, normal, metre);
                std::size_t others = 0;
                for (std::size_t i = 0; i < drawn.size(); ++i) others += std::abs(drawn[i] - expected[i]) > 3;
                EXPECT_LT(others, drawn.size() / 500) << view.name << ", " << metre;
            }
        }
}

TEST(ConstantVolume, EndsOnAnOpaqueSurfaceInside) {
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; });
    const double depth = 0.613;
    const Shape wall = square(depth); // only the lower left quarter of the square is in front of the cube
    for (const View& view : {View{"ahead", {0.1, -1, 0.2}, 30}, View{"parallel", {0.4, -1, 0.3}, 0}, views[7]})
        for (const std::size_t slices : {50, 200})
            for (const Vec3d& normal : {Vec3d{0, 1, 0}, Vec3d{1, 0, 0}, unit_of(view.from)}) {
                Frame frame = frame_of(view, {-1, 0, -1}, {1, 1, 1});
                frame.camera.target = {0.5, 0.5, 0.5};
                frame.camera.position = plus(frame.camera.target, unit_of(view.from), view.distance);
                Primitives primitives = wall.primitives();
                primitives.scalars = {};
                primitives.color = {0, 0, 0, 1};
                primitives.lit = false;
                frame.primitives.push_back(primitives);
                frame.volumes.push_back(scene.volume(normal, slices));
                frame.volumes[0].scale.range = {0, 1};
                frame.volumes[0].opacity_points = {{0, opacity}};
                const auto expected = [&](const Ray& ray) {
                    auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
                    const double wall_at = (depth - ray[0][1]) / ray[1][1];
                    const Vec3d hit = plus(ray[0], ray[1], wall_at);
                    if (wall_at > 0 && std::abs(hit[0]) < 1 && std::abs(hit[2]) < 1) to = std::min(to, wall_at);
                    return 1 - std::pow(1 - opacity, std::max(0.0, to - from));
                };
                expect_close(compare(frame, expected, 0.01), std::string(view.name) + ", " + std::to_string(slices) +
                                                                 " slices along " + testing::PrintToString(normal));
            }
}

TEST(VolumeTest, RefusesWhatDoesNotFitTogether) {
    VolumeScene scene(test::hexahedra(Box{{1, 1, 1}, 0, 1, 1}), [](const Vec3d&) { return 1.0; });
    Image image;
    Frame frame = frame_of(views[0]);
    const auto refused = [&](const Volume& volume, const char* words) {
        frame.volumes = {volume};
        EXPECT_THAT([&] { renderer().draw(frame, image); }, testing::ThrowsMessage<Error>(testing::HasSubstr(words)));
    };
    Volume volume = scene.volume({0, 1, 0}, 4);
    volume.boundary = nullptr;
    refused(volume, "lacks slices, a boundary");
    volume = scene.volume({0, 1, 0}, 4);
    volume.slices = {};
    refused(volume, "lacks slices");
    volume = scene.volume({0, 1, 0}, 4);
    color::SlabTriangles broken{{}, {0, 1, 2}};
    volume.slices = std::span(&broken, 1);
    refused(volume, "less than 0, the number of vertices");
    volume = scene.volume({0, 1, 0}, 4);
    volume.scale.map = "nothing";
    refused(volume, "there is no color map 'nothing'");
    frame.volumes = {scene.volume({0, 1, 0}, 4)};
    renderer().draw(frame, image);
}

TEST(TransferTableTest, InterpolatesOpacityAndStepsAtDoublePositions) {
    const std::vector<std::array<double, 2>> points{{0.2, 0.1}, {0.4, 0.5}, {0.4, 0.9}, {0.8, 0.3}};
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 0), 0.1);
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 0.3), 0.3);
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 0.39999999), 0.49999998);
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 0.4), 0.9);
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 0.6), 0.6);
    EXPECT_DOUBLE_EQ(color::opacity_at(points, 1), 0.3);
    EXPECT_DOUBLE_EQ(color::opacity_at({}, 0.5), 0);
    EXPECT_NEAR(1 - std::exp(-color::extinction_of(0.7)), 0.7, 1e-12);
    EXPECT_TRUE(std::isfinite(color::extinction_of(1)));
}

} // namespace
} // namespace server::render
