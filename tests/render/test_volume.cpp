// Volumes against closed forms: Beer and Lambert for a constant property, the integral for a linear one.
#include "render/transfer_table.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ciel::render {
namespace {

using test::Box;

constexpr int side = 160;

Renderer& renderer() {
    static Renderer one(Backend::automatic);
    return one;
}

struct View {
    const char* name;
    Vec3d from; // the direction to the eye
    double fov; // 0: parallel
    double distance = 3;

    friend std::ostream& operator<<(std::ostream& out, const View& view) { return out << view.name; }
};

const std::vector<View> views{
    {"along_y_parallel", {0.001, -1, 0.002}, 0},
    {"slanted_parallel", {0.4, -1, 0.3}, 0},
    {"corner_parallel", {1, 1, 1}, 0},
    {"along_x", {1, 0.003, 0.001}, 30},
    {"slanted", {-0.5, 0.9, 0.45}, 30},
    {"below", {0.3, 0.2, -1}, 45},
    {"forty_five_degrees", {1, 0.99, 0.02}, 30},
    {"corner_wide", {-1, -1, 1}, 80, 1.3},
};

// A unit cube in the middle of a black picture.
Frame frame_of(const View& view, const Vec3d& low = {0, 0, 0}, const Vec3d& high = {1, 1, 1}) {
    Frame frame;
    frame.width = frame.height = side;
    frame.bounds_min = low;
    frame.bounds_max = high;
    const Vec3d middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
    frame.camera.target = middle;
    frame.camera.position = plus(middle, unit_of(view.from), view.distance);
    frame.camera.parallel = view.fov == 0;
    frame.camera.parallel_height = 2;
    if (!frame.camera.parallel) frame.camera.fov_degrees = view.fov;
    return frame;
}

struct Difference {
    double largest = 0, mean = 0; // of 255; the mean with its sign
    int x = 0, y = 0;             // where it is largest
    int beyond = 0, pixels = 0;   // pixels that are off by more than is allowed; pixels with anything to see
};

// `expected`: 0 to 1 for a ray.
Difference compare(const Frame& frame, const std::function<double(const Ray&)>& expected, double share) {
    Image image;
    renderer().draw(frame, image);
    Difference difference;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const double wanted = 255 * expected(ray_of(frame, x + 0.5, y + 0.5));
            const double seen = image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)];
            if (wanted == 0 && seen == 0) continue;
            const double off = seen - wanted;
            ++difference.pixels;
            difference.mean += off;
            if (std::abs(off) > std::abs(difference.largest)) {
                difference.largest = off;
                difference.x = x;
                difference.y = y;
            }
            if (std::abs(off) > share * wanted + 0.75) ++difference.beyond;
        }
    difference.mean /= std::max(1, difference.pixels);
    return difference;
}

// The rasteriser snaps corners to 1/256 pixel: at the outline of the mesh a pixel may be in on one side of that and out
// on the other.
void expect_close(const Difference& difference, const std::string& what) {
    EXPECT_GT(difference.pixels, side * side / 20) << what;
    EXPECT_LE(difference.beyond, difference.pixels / 500)
        << what << ", most of all by " << difference.largest << " at " << difference.x << ", " << difference.y;
    EXPECT_LT(std::abs(difference.mean), 0.6) << what; // 0.5 where all pixels are rounded alike
}

Vec3d nearest_axis(const Vec3d& v) {
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other)
        if (std::abs(v[other]) > std::abs(v[axis])) axis = other;
    Vec3d normal{};
    normal[axis] = 1;
    return normal;
}

struct Solid {
    const char* name;
    test::Polyhedra (*make)();
    std::vector<std::array<Vec3d, 2>> boxes; // that it fills
    std::vector<std::array<Vec3d, 2>> holes; // in them

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
    {"hexahedra", [] { return test::hexahedra(Box{{3, 4, 5}, 0, 1, 0.2}); }, {{Vec3d{}, Vec3d{0.6, 0.8, 1}}}, {}},
    {"zoo", [] { return test::zoo(Box{{4, 4, 4}, 0, 3, 0.25}); }, unit_cube, {}},
    {"voronoi", [] { return test::voronoi(200, 5); }, unit_cube, {}},
    {"one_giant_cell_and_a_layer", [] { return test::giant_cell(4); }, {}, {}},
    {"void",
     [] {
         return cube_without(4, [](auto c) { return inner(c[0]) && inner(c[1]) && inner(c[2]); });
     },
     unit_cube,
     {{Vec3d{0.25, 0.25, 0.25}, Vec3d{0.75, 0.75, 0.75}}}},
    {"groove",
     [] { return cube_without(4, [](auto c) { return c[1] == 1 || (c[1] == 2 && c[2] > 1); }); },
     unit_cube,
     {{Vec3d{0, 0.25, 0}, Vec3d{1, 0.5, 1}}, {Vec3d{0, 0.5, 0.5}, Vec3d{1, 0.75, 1}}}},
    {"inner_wall", // two parts that touch without sharing a vertex: a wall of two sides in the middle
     [] {
         const auto half = test::hexahedra(Box{{2, 4, 4}, 0, 1, 0.25});
         return test::joined(half, half, {0.5, 0, 0});
     },
     unit_cube,
     {}},
};

class ConstantVolume : public testing::TestWithParam<Solid> {};

INSTANTIATE_TEST_SUITE_P(Solids, ConstantVolume, testing::ValuesIn(solids),
                         [](const auto& solid) { return std::string(solid.param.name); });

constexpr double opacity = 0.8; // after one unit

TEST_P(ConstantVolume, FollowsBeerAndLambertFromAnywhere) {
    Solid solid = GetParam();
    const test::Polyhedra mesh = solid.make();
    if (solid.boxes.empty()) { // its bounds
        std::array<Vec3d, 2> box{mesh.position(0), mesh.position(0)};
        for (test::Id v = 0; v < mesh.vertex_count(); ++v)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box[0][axis] = std::min(box[0][axis], mesh.position(v)[axis]);
                box[1][axis] = std::max(box[1][axis], mesh.position(v)[axis]);
            }
        solid.boxes.push_back(box);
    }
    VolumeScene scene(mesh, [](const Vec3d&) { return 1.0; });
    for (const View& view : views)
        for (const std::size_t slices : {50, 333})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
                Frame frame = frame_of(view, solid.boxes[0][0], solid.boxes[0][1]);
                frame.volumes.push_back(scene.volume(normal, slices));
                frame.volumes[0].range = {0, 1};
                frame.volumes[0].opacity_points = {{0, opacity}};
                const auto expected = [&](const Ray& ray) { return 1 - std::pow(1 - opacity, solid.length(ray)); };
                expect_close(compare(frame, expected, 0.01),
                             std::string(view.name) + ", " + std::to_string(slices) + " slices along " +
                                 testing::PrintToString(normal));
            }
}

} // namespace
} // namespace ciel::render
