// Clip planes cut volumes: pictures against the closed form for the kept part of each ray.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

#include <algorithm>

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

constexpr double opacity = 0.8; // opacity of one unit of length

const Vec3d off_center{0.43, 0.57, 0.51};

class ClippedVolumes : public testing::TestWithParam<Cut> {};

INSTANTIATE_TEST_SUITE_P(
    Planes, ClippedVolumes,
    testing::Values(Cut{"across_x", {plane_through(off_center, {1, 0, 0})}},
                    Cut{"across_y", {plane_through(off_center, {0, -1, 0})}},
                    Cut{"between_cells", {plane_through({0.25, 0.5, 0.5}, {-1, 0, 0})}},
                    Cut{"oblique", {plane_through(off_center, {1, -0.6, 0.35})}},
                    Cut{"wedge", {plane_through(off_center, {1, 0.2, 0}), plane_through(off_center, {-0.2, 1, 0.3})}},
                    Cut{"sheet", {plane_through({0.4, 0, 0}, {1, 0, 0}), plane_through({0.62, 0, 0}, {-1, 0, 0})}},
                    Cut{"thinner_than_a_slab",
                        {plane_through({0.5, 0.503, 0.5}, {0.3, 1, 0.8}),
                         plane_through({0.5, 0.513, 0.5}, {-0.3, -1, -0.8})}},
                    Cut{"box_by_six",
                        {plane_through({0.3, 0, 0}, {1, 0, 0}), plane_through({0.8, 0, 0}, {-1, 0, 0}),
                         plane_through({0, 0.1, 0}, {0, 1, 0}), plane_through({0, 0.77, 0}, {0, -1, 0}),
                         plane_through({0, 0, 0.35}, {0, 0, 1}), plane_through({0, 0, 0.9}, {0, 0, -1})}}),
    [](const auto& cut) { return std::string(cut.param.name); });

TEST_P(ClippedVolumes, FollowBeerAndLambertOverWhatIsLeftOfARay) {
    const Cut& cut = GetParam();
    VolumeScene scene(test::zoo(Box{{4, 4, 4}, 0, 3, 0.25}), [](const Vec3d&) { return 1.0; });
    for (const View& view : views)
        for (const std::size_t slices : {50, 333})
            for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
                Frame frame = frame_of(view);
                frame.clip = cut.planes;
                frame.volumes.push_back(scene.volume(normal, slices));
                frame.volumes[0].scale.range = {0, 1};
                frame.volumes[0].opacity_points = {{0, opacity}};
                const auto expected = [&](const Ray& ray) {
                    const auto [from, to] = cut.kept(ray, inside_box(ray, {0, 0, 0}, {1, 1, 1}));
                    return 1 - std::pow(1 - opacity, std::max(0.0, to - from));
                };
                expect_close(compare(frame, expected, 0.01), std::string(view.name) + ", " + std::to_string(slices) +
                                                                 " slices along " + testing::PrintToString(normal));
            }
}

// The mesh has a groove: a ray leaves the cube and enters it again. The planes cut both parts.
TEST(ClippedVolume, IsCutInEveryPartOfARay) {
    const test::Polyhedra whole = test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25});
    VolumeScene scene(test::keep_cells(whole, [](test::Id cell) { return cell / 4 % 4 != 1; }),
                      [](const Vec3d&) { return 1.0; });
    const Cut cut{"", {plane_through({0.5, 0.11, 0.5}, {0.2, 1, 0}), plane_through({0.5, 0.83, 0.5}, {0.1, -1, 0.2})}};
    for (const View& view : views) {
        Frame frame = frame_of(view);
        frame.clip = cut.planes;
        frame.volumes.push_back(scene.volume(nearest_axis(view.from), 100));
        frame.volumes[0].scale.range = {0, 1};
        frame.volumes[0].opacity_points = {{0, opacity}};
        const auto expected = [&](const Ray& ray) {
            const auto length = [&](const Vec3d& low, const Vec3d& high) {
                const auto [from, to] = cut.kept(ray, inside_box(ray, low, high));
                return std::max(0.0, to - from);
            };
            return 1 - std::pow(1 - opacity, length({0, 0, 0}, {1, 0.25, 1}) + length({0, 0.5, 0}, {1, 1, 1}));
        };
        expect_close(compare(frame, expected, 0.01), view.name);
    }
}

// Cells with a vertex without a value are empty, so the volume ends at x = 0.5.
TEST(ClippedVolume, HasABoundaryWhereValuesAreMissing) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}),
                      [](const Vec3d& p) { return p[0] > 0.6 ? double{nan} : 1.0; });
    for (const auto& planes : {std::vector<std::array<float, 4>>{},
                               {plane_through({0.5, 0.37, 0.5}, {0.2, 1, 0.1})},
                               {plane_through({0.2, 0.5, 0.5}, {1, 0, 0})}})
        for (const View& view : views) {
            if (view.name == std::string("eye_inside")) continue; // the eye is in the empty part of the cube
            const Cut cut{"", planes};
            Frame frame = frame_of(view);
            frame.clip = planes;
            frame.volumes.push_back(scene.volume(nearest_axis(view.from), 100));
            frame.volumes[0].scale.range = {0, 1};
            frame.volumes[0].opacity_points = {{0, opacity}};
            const auto expected = [&](const Ray& ray) {
                const auto [from, to] = cut.kept(ray, inside_box(ray, {0, 0, 0}, {0.5, 1, 1}));
                return 1 - std::pow(1 - opacity, std::max(0.0, to - from));
            };
            expect_close(compare(frame, expected, 0.01), view.name);
        }
}

// The volume is almost opaque within one slab. Along the cut, the visible property must be that of the plane, without
// steps from slab to slab.
TEST(ClippedVolume, HasNoStripesWhereItIsDense) {
    constexpr double extinction = 6.9, unit = 0.05;
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}),
                      [](const Vec3d& p) { return 0.2 + 0.4 * p[0] + 0.4 * p[1]; });
    const Cut cut{"", {plane_through(off_center, {0.5, 0.7, 0.2})}};
    for (const View& view : {views[0], views[1]}) {
        Frame frame = frame_of(view);
        frame.clip = cut.planes;
        frame.volumes.push_back(scene.volume({0, 1, 0}, 20));
        frame.volumes[0].scale.range = {0, 1};
        frame.volumes[0].opacity_points = {{0, 1 - std::exp(-extinction)}};
        frame.volumes[0].unit_length = unit;
        const auto expected = [&](const Ray& ray) {
            const auto [from, to] = cut.kept(ray, inside_box(ray, {0, 0, 0}, {1, 1, 1}));
            double light = 0, left = 1;
            constexpr double step = 0.001;
            for (double t = from; t < to && left > 1e-4; t += step) {
                const double length = std::min(step, to - t), passed = std::exp(-extinction / unit * length);
                const Vec3d p = plus(ray[0], ray[1], t + length / 2);
                light += left * (1 - passed) * (0.2 + 0.4 * p[0] + 0.4 * p[1]);
                left *= passed;
            }
            return light;
        };
        expect_close(compare(frame, expected, 0.012), view.name);
    }
}

// Only the surface of the cut is visible, so a property that changes along the view shows where the cut lies.
TEST(ClippedVolume, ShowsThePropertyWhereItIsCut) {
    VolumeScene scene(test::voronoi(200, 5), [](const Vec3d& p) { return p[1]; });
    for (const double place : {0.2, 0.5, 0.83}) {
        Frame frame = frame_of(views[0]);
        frame.clip = {plane_through({0, place, 0}, {0, 1, 0})};
        frame.volumes.push_back(scene.volume({0, 1, 0}, 100));
        frame.volumes[0].scale.range = {0, 1};
        frame.volumes[0].opacity_points = {{0, 1}};
        frame.volumes[0].unit_length = 0.1; // a tenth of the cube takes 99.9 % of the light
        const double tau = std::log(1000.0) / 0.1, rest = 1 - place;
        const double mean = place + (1 - (1 + tau * rest) * std::exp(-tau * rest)) / tau;
        Image image;
        renderer().draw(frame, image);
        const auto middle = 3 * static_cast<std::size_t>(side * side / 2 + side / 2);
        EXPECT_NEAR(image.rgb[middle] / 255.0, mean, 0.01) << place;
    }
}

TEST(ClippedVolume, IsNothingWhereThePlanesKeepNothingAndWholeWithoutThem) {
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}), [](const Vec3d&) { return 1.0; });
    Frame frame = frame_of(views[4]);
    frame.volumes.push_back(scene.volume({0, 1, 0}, 60));
    Image whole, cut, again;
    renderer().draw(frame, whole);
    frame.clip = {plane_through({0.5, 0, 0}, {1, 0, 0}), plane_through({0.4, 0, 0}, {-1, 0, 0})};
    renderer().draw(frame, cut);
    EXPECT_EQ(std::ranges::count(cut.rgb, 0), static_cast<std::ptrdiff_t>(cut.rgb.size()));
    frame.clip.clear();
    renderer().draw(frame, again);
    EXPECT_EQ(whole.rgb, again.rgb);
}

// A line in a groove of the mesh. It is in front of the visible fog once a plane removes the near part.
TEST(ClippedVolume, LeavesLinesInSightThatAreInFrontOfWhatIsKept) {
    const test::Polyhedra whole = test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25});
    VolumeScene scene(test::keep_cells(whole, [](test::Id cell) { return cell / 4 % 4 != 1; }),
                      [](const Vec3d&) { return 0.0; });
    const std::vector<Vec3f> ends{{0, 0.4F, 0.5F}, {1, 0.4F, 0.5F}};
    Frame frame = frame_of({"", {0.001, -1, 0.002}, 0});
    frame.primitives = {line_between(ends, 6)};
    frame.volumes.push_back(scene.volume({0, 1, 0}, 60));
    frame.volumes[0].scale.range = {0, 1}; // the property 0 is black
    frame.volumes[0].opacity_points = {{0, 1}};
    frame.volumes[0].unit_length = 0.1;
    Image image;
    const auto brightness = [&] {
        renderer().draw(frame, image);
        return image.rgb[3 * static_cast<std::size_t>(side / 2 * side + side / 2)];
    };
    EXPECT_LT(brightness(), 10) << "behind the near part";
    frame.clip = {plane_through({0, 0.3, 0}, {0, 1, 0})};
    EXPECT_GT(brightness(), 240);
    frame.clip = {plane_through({0, 0.45, 0}, {0, 1, 0})};
    EXPECT_LT(brightness(), 10) << "cut away itself";
}

} // namespace
} // namespace server::render
