// A fully transparent volume switches the renderer to depth peeling, but must not change the picture: transparent
// surfaces on opaque ones and through them.
#include "backends.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;
namespace {

// Surface of the cube from -0.8 to 0.8 along each axis.
Shape cube() {
    Shape all;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-0.8F, 0.8F}) {
            const Shape face = grid(3, 3, [&](double u, double v) {
                Vec3f place{};
                place[axis] = side;
                place[(axis + 1) % 3] = static_cast<float>(1.6 * u - 0.8);
                place[(axis + 2) % 3] = static_cast<float>(1.6 * v - 0.8);
                return place;
            });
            const auto first = static_cast<Index>(all.positions.size());
            all.positions.insert(all.positions.end(), face.positions.begin(), face.positions.end());
            for (const Index vertex : face.indices) all.indices.push_back(first + vertex);
        }
    return all;
}

class LayersInAir : public testing::TestWithParam<Backend> {
protected:
    LayersInAir() {
        frame.background_top = frame.background_bottom = {0, 0, 0};
        frame.bounds_min = {-1, -1, -1};
        frame.bounds_max = {4, 4, 4};
        air.scale.range = {0, 1};
        air.opacity_points = {{0, 0}, {1, 0}};
        shapes.reserve(8);
    }
    void add(Shape shape, std::array<float, 4> color) {
        shapes.push_back(std::move(shape));
        Primitives primitives = shapes.back().primitives();
        primitives.scalars = {};
        primitives.lit = false;
        primitives.color = color;
        frame.primitives.push_back(primitives);
    }
    Image drawn(int samples, bool with_air) {
        frame.samples = samples;
        frame.volumes.clear();
        if (with_air) frame.volumes.push_back(air);
        return renderer.draw(frame);
    }

    Renderer renderer{GetParam()};
    VolumeScene scene{test::hexahedra({{4, 4, 4}}), [](const Vec3d&) { return 1.0; }};
    Volume air = scene.volume({0, 1, 0}, 20);
    Frame frame = front_view();
    std::vector<Shape> shapes;
};

INSTANTIATE_TEST_SUITE_P(Backends, LayersInAir, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LayersInAir);

TEST_P(LayersInAir, ASurfaceOnABoxIsSeenAlongItsEdges) {
    add(cube(), {1, 0, 0, 1});
    add(cube(), {0, 1, 0, 0.5F});
    for (const Vec3d& eye : {Vec3d{2, -4, 1.5}, Vec3d{-1, -4, 3}, Vec3d{3, -4, -0.4}})
        for (const bool parallel : {true, false})
            for (const int samples : {1, 4}) {
                frame.camera.position = eye;
                frame.camera.parallel = parallel;
                const Image image = drawn(samples, true);
                const auto red = [&](int x, int y) {
                    return image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
                };
                int inside = 0, off = 0;
                for (int y = 1; y + 1 < image.height; ++y)
                    for (int x = 1; x + 1 < image.width; ++x) {
                        if (std::min({red(x, y - 1), red(x - 1, y), red(x + 1, y), red(x, y + 1)}) < 120) continue;
                        ++inside;
                        off += std::abs(red(x, y) - 128) > 2 ? 1 : 0;
                    }
                EXPECT_GT(inside, 8000);
                EXPECT_EQ(off, 0) << samples << " samples, parallel: " << parallel << ", from " << eye[0];
            }
}

TEST_P(LayersInAir, SurfacesCrossWhereTheyDo) {
    const auto leaning = [](float lean) {
        return grid(1, 1, [&](double u, double v) {
            const auto x = static_cast<float>(3 * u - 1.5), z = static_cast<float>(3 * v - 1.5);
            return Vec3f{x, lean * (x + 0.3F * z), z};
        });
    };
    add(leaning(0.5F), {1, 1, 1, 1});
    add(leaning(-0.3F), {1, 0, 0, 0.5F});
    for (const int samples : {1, 4}) {
        const Image without = drawn(samples, false), with = drawn(samples, true);
        int differing = 0;
        for (std::size_t i = 0; i < with.rgb.size(); ++i)
            differing += std::abs(with.rgb[i] - without.rgb[i]) > 2 ? 1 : 0;
        EXPECT_EQ(differing, 0) << samples << " samples";
    }
}

} // namespace
} // namespace server::render
