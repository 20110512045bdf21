// Volumes of a few thick slabs. Each fragment extrapolates the property along its ray by the gradient, limited to the
// range of its cell.
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

#include <gmock/gmock.h>

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

double ramp(const Vec3d& p) { return 0.5 * p[0] + 0.2 * p[1] + 0.3 * p[2]; }
double extinction(const Vec3d& p) { return -std::log(1 - 0.9 * ramp(p)); }

// White light. Its brightness depends only on the integral of the extinction, which is exact for any number of slabs.
Volume white(Volume volume) {
    volume.scale.points = {{0, {255, 255, 255}}, {1, {255, 255, 255}}};
    volume.scale.range = {0, 1};
    volume.opacity_points = {{0, 0}, {1, 0.9}};
    return volume;
}

double light_between(const Ray& ray, double from, double to) {
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i < steps && to > from; ++i)
        sum += extinction(plus(ray[0], ray[1], from + (i + 0.5) * (to - from) / steps)) * (to - from) / steps;
    return 1 - std::exp(-sum);
}

class ThickSlabs : public testing::TestWithParam<std::size_t> {
protected:
    // One cell, so no limit of a cell applies inside.
    VolumeScene scene{test::hexahedra(Box{{1, 1, 1}, 0, 1, 1}), ramp};

    void expect_integral(const Frame& shown, const View& view,
                         const std::function<std::array<double, 2>(const Ray&)>& inside) {
        for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
            Frame frame = shown;
            frame.volumes = {white(scene.volume(normal, GetParam()))};
            const auto expected = [&](const Ray& ray) {
                const auto [from, to] = inside(ray);
                return light_between(ray, from, to);
            };
            expect_close(compare(frame, expected, 0.02),
                         std::string(view.name) + ", slabs along " + testing::PrintToString(normal));
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Count, ThickSlabs, testing::Values(1, 2, 5));

TEST_P(ThickSlabs, OfALinearFieldHaveTheIntegral) {
    for (const View& view : views)
        expect_integral(frame_of(view), view, [](const Ray& ray) { return inside_box(ray, {0, 0, 0}, {1, 1, 1}); });
}

// The kept part of a slab lies on one side of its slice. Swapped ends of the ray segment would give a wrong integral.
TEST_P(ThickSlabs, OfALinearFieldHaveTheIntegralOfWhatAPlaneKeeps) {
    for (const float side : {1.0F, -1.0F})
        for (const View& view : views) {
            Frame frame = frame_of(view);
            frame.clip = {{side * 0.6F, side * 0.64F, side * 0.48F, side * -0.8F}};
            expect_integral(frame, view, [&](const Ray& ray) {
                const auto& [x, y, z, w] = frame.clip[0];
                auto [from, to] = inside_box(ray, {0, 0, 0}, {1, 1, 1});
                const double at = x * ray[0][0] + y * ray[0][1] + z * ray[0][2] + w;
                const double rate = x * ray[1][0] + y * ray[1][1] + z * ray[1][2];
                (rate > 0 ? from : to) = rate > 0 ? std::max(from, -at / rate) : std::min(to, -at / rate);
                return std::array{from, to};
            });
        }
}

// The property rises from 0 to 1 within one layer of cells. Vertex gradients average neighboring cells, so
// extrapolation from the flat cells would exceed the range of every cell.
TEST(ThickSlabsOfAStep, NeverLeaveTheRangeOfACell) {
    VolumeScene scene(test::hexahedra(Box{{4, 4, 4}, 0, 1, 0.25}),
                      [](const Vec3d& p) { return p[0] < 0.4 ? 0.0 : 1.0; });
    for (const View& view : views)
        for (const std::size_t slices : {1, 2, 4, 9})
            for (const Vec3d& normal : {Vec3d{1, 0, 0}, nearest_axis(view.from), unit_of(view.from)}) {
                Frame frame = frame_of(view);
                frame.volumes = {white(scene.volume(normal, slices))};
                frame.volumes[0].scale.range = {-1, 2};
                // Opaque only for values that no cell contains.
                frame.volumes[0].opacity_points = {{0, 0.9}, {0.3, 0.9}, {0.3, 0}, {0.7, 0}, {0.7, 0.9}, {1, 0.9}};
                Image image;
                renderer().draw(frame, image);
                EXPECT_LE(*std::ranges::max_element(image.rgb), 1)
                    << view.name << ", " << slices << " slices along " << testing::PrintToString(normal);
            }
}

// Four sheets of fog with gaps. Each line in a gap or behind all sheets is hidden by the first kept part of the ray.
TEST(ClippedSheets, HideLinesBehindTheFirstPartThatIsKept) {
    const test::Polyhedra whole = test::hexahedra(Box{{8, 8, 8}, 0, 1, 0.125});
    VolumeScene scene(test::keep_cells(whole, [](test::Id cell) { return cell / 8 % 8 % 2 == 0; }),
                      [](const Vec3d&) { return 0.0; });
    for (int first = 0; first < 4; ++first) // the first kept sheet is from first / 4 to first / 4 + 1 / 8
        for (int gap = first; gap <= 4; ++gap) {
            // y of the line. Gap 0 is in front of everything.
            const float place = static_cast<float>(gap) / 4 - 0.0625F;
            const std::vector<Vec3f> ends{{0, place, 0.5F}, {1, place, 0.5F}};
            Frame frame = frame_of({"", {0.001, -1, 0.002}, 0}, {0, -0.1, 0}, {1, 1.1, 1});
            frame.primitives = {line_between(ends, 6)};
            frame.clip = {{0, 1, 0, 0.1F - static_cast<float>(first) / 4}};
            frame.volumes = {scene.volume({0, 1, 0}, 64)};
            frame.volumes[0].scale.range = {0, 1}; // the property 0 is black
            frame.volumes[0].opacity_points = {{0, 1}};
            frame.volumes[0].unit_length = 0.05;
            Image image;
            renderer().draw(frame, image);
            const int seen = image.rgb[3 * static_cast<std::size_t>(side / 2 * side + side / 2)];
            if (gap == first)
                EXPECT_GT(seen, 240) << "before sheet " << first;
            else
                EXPECT_LT(seen, 10) << "first sheet " << first << ", line behind sheet " << gap - 1;
        }
}

} // namespace
} // namespace server::render
