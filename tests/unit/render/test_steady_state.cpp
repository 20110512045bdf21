// While the camera turns or a plane moves, the renderer creates no OpenGL objects and sends no unchanged data.
#include "backends.hpp"
#include "counted_gl.hpp"
#include "render/painter.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>

namespace server::render {
using namespace ciel;
namespace {

std::size_t bytes_of(const Primitives& primitives) {
    return primitives.positions.size_bytes() + primitives.normals.size_bytes() + primitives.scalars.size_bytes() +
           primitives.indices.size_bytes();
}

class SteadyStateTest : public testing::TestWithParam<Backend> {
protected:
    SteadyStateTest() : chosen(make_context(GetParam())) {
        EXPECT_TRUE(make_current(*chosen.context));
        painter.emplace(counted_gl(*chosen.context));
    }

    GlCounts draw() {
        (void)take_counts();
        (void)painter->draw(frame, {});
        return take_counts();
    }
    void turn() {
        angle += 0.1;
        frame.camera.position = {5 * std::sin(angle), -5 * std::cos(angle), 0.5};
    }
    Primitives& add(const Shape& shape) {
        frame.primitives.push_back(shape.primitives());
        frame.primitives.back().identity = ++identity;
        frame.primitives.back().revision = ++revision;
        return frame.primitives.back();
    }
    void replace(std::size_t at, const Shape& shape) {
        Primitives primitives = shape.primitives();
        primitives.identity = frame.primitives[at].identity;
        primitives.scale = frame.primitives[at].scale;
        primitives.color = frame.primitives[at].color;
        primitives.revision = ++revision;
        frame.primitives[at] = primitives;
    }
    // Checks that the last frame created no objects and allocated no storage.
    void expect_nothing_made(const GlCounts& counts) {
        EXPECT_EQ(counts.objects, 0);
        EXPECT_EQ(counts.storage, 0);
        EXPECT_EQ(counts.texture_updates, 0);
    }
    void expect_nothing_sent(const GlCounts& counts) {
        expect_nothing_made(counts);
        EXPECT_EQ(counts.bytes, 0U);
    }

    ChosenContext chosen;
    std::optional<Painter> painter;
    Frame frame = front_view();
    double angle = 0;
    std::uint64_t identity = 0, revision = 0;
};

INSTANTIATE_TEST_SUITE_P(Backends, SteadyStateTest, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SteadyStateTest);

TEST_P(SteadyStateTest, TheFirstFrameIsCounted) {
    const Shape plane = square(0);
    add(plane);
    const GlCounts counts = draw();
    EXPECT_EQ(counts.bytes, bytes_of(frame.primitives[0]));
    EXPECT_GT(counts.objects, 0);
    EXPECT_GT(counts.storage, 0);
}

TEST_P(SteadyStateTest, ADraggedSurfaceIsAllThatIsSent) {
    const Shape other = square(0.5);
    const Shape first = sphere(0.5);
    add(other);
    add(first);
    (void)draw();
    for (const double radius : {0.6, 0.7, 0.3}) {
        const Shape shape = sphere(radius);
        replace(1, shape);
        const GlCounts counts = draw();
        expect_nothing_made(counts);
        EXPECT_EQ(counts.bytes, bytes_of(frame.primitives[1]));
    }
}

TEST_P(SteadyStateTest, ACameraThatTurnsSendsNothing) {
    const Shape ball = sphere(0.6), plane = square(0);
    add(ball);
    add(plane);
    (void)draw();
    for (int i = 0; i < 5; ++i) {
        turn();
        expect_nothing_sent(draw());
    }
}

TEST_P(SteadyStateTest, AHiddenLayerLeavesTheOthersWhereTheyAre) {
    const Shape ball = sphere(0.6), plane = square(0), small = sphere(0.2);
    add(ball);
    add(plane);
    add(small);
    (void)draw();
    const Primitives hidden = frame.primitives[0];
    frame.primitives.erase(frame.primitives.begin());
    expect_nothing_sent(draw());
    std::swap(frame.primitives[0], frame.primitives[1]);
    expect_nothing_sent(draw());
    frame.primitives.insert(frame.primitives.begin() + 1, hidden);
    expect_nothing_sent(draw());
}

TEST_P(SteadyStateTest, OtherColorsSendNoVertices) {
    const Shape ball = sphere(0.6), plane = square(0);
    add(ball);
    add(plane);
    (void)draw();
    frame.primitives[0].color = {1, 0, 0, 1};
    frame.primitives[1].scale.range = {-2, 2};
    const GlCounts counts = draw();
    EXPECT_EQ(counts.bytes, 0U);
    EXPECT_EQ(counts.objects, 0);
    EXPECT_EQ(counts.storage, 2) << "the colors of the frame's scales, and their rules";
}

TEST_P(SteadyStateTest, TransparentTrianglesAreSentOnceAndSortedForEachView) {
    const Shape ball = sphere(0.6), plane = square(0);
    add(ball).color[3] = 0.5F;
    add(plane).color[3] = 0.5F;
    const std::size_t indices = frame.primitives[0].indices.size_bytes() + frame.primitives[1].indices.size_bytes();
    (void)draw();
    expect_nothing_sent(draw());
    turn();
    const GlCounts turned = draw();
    expect_nothing_made(turned);
    EXPECT_EQ(turned.bytes, indices);
    frame.primitives[1].color[3] = 0.7F;
    EXPECT_GT(draw().bytes, indices) << "opacity is a vertex's";
}

TEST_P(SteadyStateTest, AStillAfterAStillMakesNothing) {
    const Shape ball = sphere(0.6), plane = square(0);
    add(ball).color[3] = 0.5F;
    add(plane);
    frame.samples = 4;
    (void)draw();
    for (int i = 0; i < 3; ++i) {
        turn();
        expect_nothing_made(draw());
    }
}

TEST_P(SteadyStateTest, AVolumeIsSentOnce) {
    VolumeScene scene(test::hexahedra({{3, 3, 3}, 0, 1, 1.0 / 3}), [](const Vec3d& p) { return p[0]; });
    Volume volume = scene.volume({0, 1, 0}, 15);
    frame.volumes = {volume};
    const Shape plane = square(0.5), ball = sphere(0.3);
    add(plane);
    const GlCounts first = draw();
    EXPECT_GT(first.bytes, 0U);
    for (int i = 0; i < 5; ++i) {
        turn();
        expect_nothing_sent(draw());
    }
    frame.volumes[0].stride = 3; // the stride while the camera moves
    (void)draw();
    for (const std::size_t stride : {1, 3, 1}) {
        frame.volumes[0].stride = stride;
        turn();
        expect_nothing_sent(draw());
    }
    add(ball).color[3] = 0.5F;
    (void)draw();
    turn();
    expect_nothing_sent(draw()); // layers inside a volume are depth-peeled, so no sorted triangle order is sent
}

// Every kind of layer: nothing is sent or created again while the camera turns or a plane moves.
class SteadyScenes : public SteadyStateTest {
protected:
    void add_all(float opacity) {
        Primitives& edges = add(lines);
        edges.lines = true;
        edges.color = {0, 0, 0, opacity};
        Primitives& dots = add(corners);
        dots.points = true;
        add(ball);
        add(plane);
        frame.occlusion = {0.5, 1};
    }
    // Turns the camera and moves a plane, and expects no uploads. `first_rounds` unchecked rounds come first, because
    // more layers of ray segments may need storage.
    void expect_steady(const char* what, int first_rounds = 0) {
        SCOPED_TRACE(what);
        const double from = angle;
        for (int round = -first_rounds; round <= 0; ++round) {
            angle = from;
            frame.clip = {{1, 0, 0, 2}};
            (void)draw();
            for (int i = 0; i < 4; ++i) {
                turn();
                const GlCounts turned = draw();
                frame.clip[0][3] -= 0.3F;
                const GlCounts cut = draw();
                if (round < 0) continue;
                expect_nothing_sent(turned);
                expect_nothing_sent(cut);
            }
        }
    }

    Shape ball = sphere(0.6), plane = square(0.3);
    Shape lines{{{-1, 0, -1}, {1, 0, 1}, {-1, -0.5F, 1}}, {}, {}, {0, 1, 1, 2}};
    Shape corners{{{-1, 0, -1}, {1, 0, 1}, {-1, -0.5F, 1}}, {}, {}, {0, 1, 2}};
};

INSTANTIATE_TEST_SUITE_P(Backends, SteadyScenes, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SteadyScenes);

TEST_P(SteadyScenes, LinesPointsOcclusionAndAMovingPlane) {
    add_all(1);
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        expect_steady(samples == 1 ? "moving" : "still");
    }
}

TEST_P(SteadyScenes, LinesToSeeThrough) {
    add_all(0.5F);
    for (const int samples : {1, 4}) {
        frame.samples = samples;
        expect_steady(samples == 1 ? "moving" : "still");
    }
}

TEST_P(SteadyStateTest, TransparentPointsAreSentOnceAndSortedForEachView) {
    Shape places = sphere(0.6);
    places.indices.clear();
    for (Index i = 0; i < places.positions.size(); ++i) places.indices.push_back(i);
    Primitives& dots = add(places);
    dots.normals = {};
    dots.points = true;
    dots.color[3] = 0.5F;
    const Shape ball = sphere(0.5), plane = square(0);
    add(ball);
    add(plane).color[3] = 0.5F;
    for (const int samples : {4, 1}) {
        frame.samples = samples;
        (void)draw();
        (void)draw();
        expect_nothing_sent(draw());
        for (int i = 0; i < 3; ++i) {
            turn();
            const GlCounts turned = draw();
            expect_nothing_made(turned);
            EXPECT_EQ(turned.bytes, places.indices.size() * sizeof(Index)) << "their order";
        }
    }
    frame.primitives[0].point_size = 9;
    EXPECT_GT(draw().bytes, places.indices.size() * sizeof(Index)) << "the size is a vertex's";
}

TEST_P(SteadyScenes, SeveralVolumesAmongAllOfIt) {
    add_all(1);
    frame.primitives.back().color[3] = 0.5F;
    VolumeScene warm(test::hexahedra({{3, 3, 3}, 0, 1, 1.0 / 3}), [](const Vec3d& p) { return p[0]; });
    VolumeScene cold(test::hexahedra({{3, 3, 3}, -0.5, 1, 1.0 / 3}), [](const Vec3d& p) { return p[2]; });
    frame.volumes = {warm.volume({0, 1, 0}, 15), cold.volume({0, 1, 0}, 9)};
    frame.volumes[1].identity = 2;
    for (const std::size_t stride : {3U, 1U}) {
        for (Volume& volume : frame.volumes) {
            volume.stride = stride;
            volume.coarseness = stride > 1 ? 2 : 1;
        }
        frame.samples = stride > 1 ? 1 : 4;
        expect_steady(stride > 1 ? "moving" : "still", 1);
    }
}

TEST_P(SteadyStateTest, WritingIsSentWhenItChanges) {
    const Shape plane = square(0);
    add(plane);
    frame.annotations.title = "Steady";
    frame.annotations.legends.push_back({"s", "m", {}});
    (void)draw();
    expect_nothing_sent(draw());
    frame.annotations.triad = true;
    (void)draw();
    turn();
    const GlCounts turned = draw();
    expect_nothing_made(turned);
    EXPECT_GT(turned.bytes, 0U) << "the triad turns";
}

} // namespace
} // namespace server::render
