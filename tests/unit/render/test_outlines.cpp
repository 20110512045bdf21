// In stills, outlines of opaque surfaces in fog are as smooth as outlines without fog, which are multisampled. The
// expected brightness is the mean over 8 x 8 rays in each pixel.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

constexpr double fog_opacity = 0.9;
constexpr int parts = 8; // rays per pixel along each axis

Ray ray_of_part(const Frame& frame, int x, int y, int part) {
    const int column = part % parts, row = part / parts;
    return ray_of(frame, x + (column + 0.5) / parts, y + (row + 0.5) / parts);
}

struct Ball {
    Vec3d center;
    double radius;

    // Distance along the ray to the first intersection, infinite when there is none.
    [[nodiscard]] double hit(const Ray& ray) const { return hits(ray)[0]; }
    [[nodiscard]] std::array<double, 2> hits(const Ray& ray) const {
        const Vec3d to = plus(center, ray[0], -1);
        const double along = to[0] * ray[1][0] + to[1] * ray[1][1] + to[2] * ray[1][2];
        const double apart = to[0] * to[0] + to[1] * to[1] + to[2] * to[2] - along * along;
        constexpr double never = std::numeric_limits<double>::infinity();
        if (apart >= radius * radius) return {never, never};
        const double half = std::sqrt(radius * radius - apart);
        return {along - half, along + half};
    }
};

class OutlineInFog : public testing::Test {
protected:
    void SetUp() override {
        frame.samples = 4;
        frame.bounds_min = {-1, -0.2, -1}; // bounds of everything drawn
        Volume volume = fog.volume({0, 1, 0}, 100);
        volume.scale.points = {{0, {255, 255, 255}}, {1, {255, 255, 255}}};
        volume.scale.range = {0, 1};
        volume.opacity_points = {{0, fog_opacity}};
        frame.volumes = {volume};
        add(sphere(ball.radius, ball.center, 256));
    }
    Primitives& add(const Shape& shape) {
        shapes.push_back(shape);
        Primitives primitives = shapes.back().primitives();
        primitives.scalars = {};
        primitives.color = {0, 0, 0, 1};
        primitives.lit = false;
        frame.primitives.push_back(primitives);
        return frame.primitives.back();
    }
    [[nodiscard]] double light(const Ray& ray) const {
        auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
        to = std::min(to, (wall - ray[0][1]) / ray[1][1]);
        if (!(from < to)) return 0;
        double sum = 0, left = 1;
        for (const double next : {std::min(to, ball.hits(ray)[0]), std::min(to, ball.hits(ray)[1]), to}) {
            const double passed = std::pow(1 - fog_opacity, next - from);
            sum += left * (1 - passed);
            left *= passed * (next < to ? 1 - ball_opacity : 1);
            from = next;
        }
        return sum;
    }
    // Mean error of the pixels on the ball's outline, relative to the step in brightness there. `dimmed`: share of the
    // light that everything else in front lets through.
    [[nodiscard]] double roughness(double dimmed = 1) {
        Image image;
        renderer().draw(frame, image);
        double sum = 0;
        int pixels = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                double mean = 0, least = 1, most = 0;
                int on_ball = 0;
                for (int i = 0; i < parts * parts; ++i) {
                    const Ray ray = ray_of_part(frame, x, y, i);
                    const double here = light(ray);
                    on_ball += std::isfinite(ball.hit(ray)) ? 1 : 0;
                    mean += here / (parts * parts);
                    least = std::min(least, here);
                    most = std::max(most, here);
                }
                if (on_ball == 0 || on_ball == parts * parts) continue;
                const double seen = image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)] / 255.0;
                sum += std::abs(seen - dimmed * mean) / (dimmed * (most - least));
                ++pixels;
            }
        EXPECT_GT(pixels, 100);
        return sum / pixels;
    }

    VolumeScene fog{test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; }};
    Ball ball{{0.5, 0.5, 0.5}, 0.3};
    double ball_opacity = 1;                               // opacity of the ball's black surface
    double wall = std::numeric_limits<double>::infinity(); // position of an opaque wall along y
    std::vector<Shape> shapes = [] {
        std::vector<Shape> kept;
        kept.reserve(4);
        return kept;
    }();
    Frame frame = frame_of({"", {0.2, -1, 0.15}, 30});
};

// Limit on the roughness. Four samples have an error of about this size; one sample has an error of 0.25.
constexpr double smooth = 0.12;

TEST_F(OutlineInFog, IsSmooth) { EXPECT_LT(roughness(), smooth); }

TEST_F(OutlineInFog, IsSmoothInAParallelView) {
    frame = frame_of({"", {0.2, -1, 0.15}, 0});
    SetUp();
    EXPECT_LT(roughness(), smooth);
}

TEST_F(OutlineInFog, IsSmoothInFrontOfAWall) {
    wall = 0.9;
    add(square(wall));
    EXPECT_LT(roughness(), smooth);
}

// Surfaces are drawn further back when thick lines may lie on them. That offset must not move steep outlines.
TEST_F(OutlineInFog, IsSmoothWithLinesAround) {
    Shape line;
    line.positions = {{0, 0, 0}, {0, 0, 1}};
    line.indices = {0, 1};
    add(line).lines = true;
    frame.primitives.back().line_width = 8;
    EXPECT_LT(roughness(), smooth);
}

// Each sample of a pixel must use the fog in front of its own surface, not the fog of the pixel's single ray.
TEST_F(OutlineInFog, IsSmoothOfATransparentBall) {
    ball_opacity = 0.8;
    frame.primitives[0].color[3] = 0.8F;
    EXPECT_LT(roughness(), smooth);
}

// The volumes are opaque within one or two pixels.
class OutlineOfAVolume : public testing::Test {
protected:
    static Volume rock(VolumeScene& scene, const Vec3d& normal = {0, 1, 0}) {
        Volume volume = scene.volume(normal, 60);
        volume.scale.points = {{0, {255, 255, 255}}, {1, {255, 255, 255}}};
        volume.scale.range = {0, 1};
        volume.opacity_points = {{0, 1}};
        volume.unit_length = 0.002;
        return volume;
    }
    // Mean error, from 0 to 1, of the partly covered pixels.
    static double roughness(const Frame& frame, const std::function<double(const Ray&)>& light) {
        Image image;
        renderer().draw(frame, image);
        double off = 0;
        int pixels = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                double sum = 0;
                int met = 0;
                for (int i = 0; i < parts * parts; ++i) {
                    const double here = light(ray_of_part(frame, x, y, i));
                    sum += here;
                    met += here > 0 ? 1 : 0;
                }
                if (met == 0 || met == parts * parts) continue;
                off += std::abs(image.rgb[3 * static_cast<std::size_t>(y * frame.width + x)] / 255.0 -
                                sum / (parts * parts));
                ++pixels;
            }
        EXPECT_GT(pixels, 100);
        return off / pixels;
    }
    static bool meets_cube(const Ray& ray) {
        const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
        return from < to;
    }
    VolumeScene cube{test::hexahedra(Box{{2, 2, 2}, 0, 1, 0.5}), [](const Vec3d&) { return 1.0; }};
};

const std::vector<View> outline_views{{"perspective", {0.3, -1, 0.4}, 30}, {"parallel", {0.3, -1, 0.4}, 0}};

TEST_F(OutlineOfAVolume, IsSmooth) {
    for (const View& view : outline_views)
        for (const bool among_layers : {false, true}) {
            Frame frame = frame_of(view);
            frame.samples = 4;
            frame.volumes = {rock(cube)};
            const Shape behind = square(0.99); // behind the opaque front of the volume
            Primitives sheet = behind.primitives();
            sheet.scalars = {};
            sheet.color = {0, 0, 0, 0.5F};
            if (among_layers) frame.primitives.push_back(sheet);
            EXPECT_LT(roughness(frame, meets_cube), smooth) << view.name << (among_layers ? ", among layers" : "");
        }
}

// Thin volume at an edge seen from the side: from one ray to the next, the length inside the mesh rises steeply.
TEST_F(OutlineOfAVolume, IsSmoothWhereItIsThinAtItsEdge) {
    for (const View& view : outline_views)
        for (const auto& [unit_length, most] : {std::array{0.3, 0.01}, {0.1, 0.02}, {0.03, 0.05}, {0.01, 0.08}}) {
            Frame frame = frame_of(view);
            frame.samples = 4;
            frame.volumes = {rock(cube)};
            frame.volumes[0].opacity_points = {{0, 0.9}};
            frame.volumes[0].unit_length = unit_length;
            const auto light = [unit = unit_length](const Ray& ray) {
                const auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
                return from < to ? 1 - std::pow(0.1, (to - from) / unit) : 0;
            };
            EXPECT_LT(roughness(frame, light), most) << view.name << ", " << unit_length;
        }
}

// Between two clip planes there may be no mesh face. Only the planes tell then which samples are covered.
TEST_F(OutlineOfAVolume, IsSmoothWherePlanesCutIt) {
    const Vec3d middle{0.43, 0.57, 0.51};
    const Cut one{"one plane", {plane_through(middle, {1, -0.6, 0.35})}};
    const Cut behind{"from behind", {plane_through(middle, {-0.2, 1, 0.3})}};
    const Cut wedge{"a wedge", {plane_through(middle, {1, 0.2, 0}), plane_through(middle, {-0.2, 1, 0.3})}};
    const Cut sheet{"a sheet",
                    {plane_through(middle, {0.2, 1, 0.1}), plane_through({0.45, 0.7, 0.5}, {-0.2, -1, -0.1})}};
    const Cut box{"a box",
                  {plane_through({0.3, 0, 0}, {1, 0.1, 0}), plane_through({0.8, 0, 0}, {-1, 0, 0.1}),
                   plane_through({0, 0.45, 0}, {0, 1, 0.1}), plane_through({0, 0.77, 0}, {0, -1, 0}),
                   plane_through({0, 0, 0.35}, {0, 0, 1}), plane_through({0, 0, 0.9}, {0.1, 0, -1})}};
    const View inside{"eye inside", {0.3, -1, 0.4}, 70, 0.3};
    for (const Cut& cut : {one, behind, wedge, sheet, box})
        for (const View& view : {outline_views[0], outline_views[1], inside}) {
            // The volume covers the whole picture, so there is no outline.
            if (view.distance < 1 && cut.planes.size() < 6) continue;
            Frame frame = frame_of(view);
            frame.samples = 4;
            frame.volumes = {rock(cube)};
            frame.clip = cut.planes;
            const auto meets = [&](const Ray& ray) {
                const auto [from, to] = cut.kept(ray, inside_box(ray, {0, 0, 0}, {1, 1, 1}));
                return from < to;
            };
            EXPECT_LT(roughness(frame, meets), smooth) << cut.name << ", " << view.name;
            frame.bounds_max[1] = 0.9; // bounds smaller than the mesh
            EXPECT_LT(roughness(frame, meets), smooth) << cut.name << ", " << view.name << ", in narrow bounds";
        }
}

// Two volumes with different meshes have different outlines.
TEST_F(OutlineOfAVolume, IsSmoothOfEachOfSeveral) {
    VolumeScene slab(test::hexahedra(Box{{4, 1, 1}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; });
    for (const View& view : outline_views)
        for (const bool swapped : {false, true}) {
            Frame frame = frame_of(view);
            frame.samples = 4;
            frame.volumes = {rock(cube), rock(slab)};
            if (swapped) std::swap(frame.volumes[0], frame.volumes[1]);
            EXPECT_LT(roughness(frame, meets_cube), smooth) << view.name << (swapped ? ", swapped" : "");
        }
}

// Pixel coordinates of a point.
std::array<double, 2> pixel_of(const Frame& frame, const Vec3d& place) {
    const Ray middle = ray_of(frame, frame.width / 2.0, frame.height / 2.0);
    const auto along = [&](const Vec3d& direction) {
        const Vec3d to = plus(place, middle[0], -1);
        return to[0] * direction[0] + to[1] * direction[1] + to[2] * direction[2];
    };
    const Vec3d right = unit_of(cross_of(middle[1], frame.camera.up)), up = cross_of(right, middle[1]);
    const double half = frame.camera.parallel
                            ? frame.camera.parallel_height / 2
                            : along(middle[1]) * std::tan(frame.camera.fov_degrees * std::acos(-1.0) / 360);
    const double pixels = frame.height / 2.0 / half;
    return {frame.width / 2.0 + pixels * along(right), frame.height / 2.0 - pixels * along(up)};
}

bool is_in_front_of_cube(const Frame& frame, const Vec3d& place) {
    const auto [x, y] = pixel_of(frame, place);
    const Ray ray = ray_of(frame, x, y);
    const Vec3d to = plus(place, ray[0], -1);
    const double there = to[0] * ray[1][0] + to[1] * ray[1][1] + to[2] * ray[1][2];
    const auto [from, end] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
    return from >= end || there < from + 1e-3;
}

// True when the pixel and its eight neighbors are inside the picture.
bool is_in_picture(const Image& image, const std::array<double, 2>& place) {
    return place[0] >= 1 && place[1] >= 1 && place[0] < image.width - 1 && place[1] < image.height - 1;
}

int darkest_around(const Image& image, const std::array<double, 2>& place) {
    int darkest = 255;
    for (int y = static_cast<int>(place[1]) - 1; y <= static_cast<int>(place[1]) + 1; ++y)
        for (int x = static_cast<int>(place[0]) - 1; x <= static_cast<int>(place[0]) + 1; ++x)
            darkest = std::min<int>(darkest, image.rgb[3 * static_cast<std::size_t>(y * image.width + x)]);
    return darkest;
}

// The lines coincide with mesh edges. Rounding must not hide parts of them behind the volume.
TEST_F(OutlineOfAVolume, LinesAlongTheEdgesOfItsMeshAreWhole) {
    const std::array<std::array<Vec3d, 2>, 3> edges{{{{{0, 0, 0}, {0, 0, 1}}}, //
                                                     {{{0, 0, 1}, {1, 0, 1}}}, //
                                                     // The edges at the corner nearest to the eye.
                                                     {{{0, 0, 1}, {0, 1, 1}}}}};
    std::vector<Vec3f> ends;
    for (const auto& edge : edges)
        for (const Vec3d& end : edge)
            ends.push_back({static_cast<float>(end[0]), static_cast<float>(end[1]), static_cast<float>(end[2])});
    Primitives lines = line_between(ends, 1.5F, {0, 0, 0, 1});
    const std::vector<Index> pairs{0, 1, 2, 3, 4, 5};
    lines.indices = pairs;
    for (const View& view : {View{"perspective", {-0.5, -1, 0.6}, 30}, View{"steep", {-0.3, -1, 0.25}, 30},
                             View{"parallel", {-0.5, -1, 0.6}, 0}})
        for (const int samples : {1, 4}) {
            Frame frame = frame_of(view);
            frame.width = frame.height = 400;
            frame.samples = samples;
            frame.volumes = {rock(cube)};
            if (samples == 1) frame.volumes[0].coarseness = 2;
            frame.primitives = {lines};
            Image image;
            renderer().draw(frame, image);
            int places = 0;
            for (const auto& [from, to] : edges)
                for (double share = 0.03; share < 0.97; share += 0.005) {
                    const Vec3d place = plus(from, plus(to, from, -1), share);
                    ASSERT_TRUE(is_in_front_of_cube(frame, place));
                    if (!is_in_picture(image, pixel_of(frame, place))) continue;
                    EXPECT_LT(darkest_around(image, pixel_of(frame, place)), 110)
                        << view.name << ", " << samples << " samples, at " << place[0] << ' ' << place[1] << ' '
                        << place[2];
                    ++places;
                }
            EXPECT_GT(places, 500);
        }
}

// A line well behind the volume's boundary is hidden.
TEST_F(OutlineOfAVolume, ALineInsideIsHidden) {
    const std::vector<Vec3f> ends{{0.05F, 0.05F, 0.2F}, {0.05F, 0.05F, 0.8F}};
    const Primitives line = line_between(ends, 1.5F, {0, 0, 0, 1});
    for (const int samples : {1, 4}) {
        Frame frame = frame_of({"perspective", {-0.5, -1, 0.6}, 30});
        frame.samples = samples;
        frame.volumes = {rock(cube)};
        frame.primitives = {line};
        Image image;
        renderer().draw(frame, image);
        for (double z = 0.25; z < 0.75; z += 0.05)
            EXPECT_GT(darkest_around(image, pixel_of(frame, {0.05, 0.05, z})), 240) << samples << ", " << z;
    }
}

// The sheet in front of the fog turns depth peeling on.
TEST_F(OutlineInFog, IsSmoothBehindATransparentSheet) {
    add(square(-0.1)).color[3] = 0.4F;
    EXPECT_LT(roughness(0.6), smooth);
}

} // namespace
} // namespace server::render
