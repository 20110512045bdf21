// A picture can be abandoned at every call of check_wanted, without an effect on the next picture.
#include "backends.hpp"
#include "counted_gl.hpp"
#include "render/painter.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_scene.hpp"

#include <gtest/gtest.h>
#include <optional>

namespace server::render {
using namespace ciel;
namespace {

struct Unwanted {};

using OutOfMemory = testing::TestWithParam<Backend>;

TEST_P(OutOfMemory, WhileItDrawsIsSaidAndTheNextPictureIsRight) {
    Renderer renderer(GetParam());
    Frame frame = front_view();
    const Image before = renderer.draw(frame);
    const std::uint64_t kept = renderer.kept_memory();
    frame.check_wanted = [] { throw std::bad_alloc(); };
    try {
        (void)renderer.draw(frame);
        FAIL() << "the picture was drawn";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("ran out of memory while it drew a picture of"), std::string::npos);
    }
    EXPECT_EQ(renderer.kept_memory(), 0U) << "the context is gone, because it may lack buffers";
    frame.check_wanted = nullptr;
    EXPECT_EQ(renderer.draw(frame).rgb, before.rgb);
    EXPECT_EQ(renderer.kept_memory(), kept);
}

INSTANTIATE_TEST_SUITE_P(Backends, OutOfMemory, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(OutOfMemory);

class GivenUpTest : public testing::TestWithParam<Backend> {
protected:
    GivenUpTest() : chosen(make_context(GetParam())) {
        EXPECT_TRUE(make_current(*chosen.context));
        painter.emplace(counted_gl(*chosen.context));
        other = front_view();
        frame = front_view();
        for (Frame* each : {&frame, &other}) each->width = each->height = 48;
        frame.occlusion = {0.5, 1};
        frame.clip = {{1, 0, 0, 0.8F}};
        other.background_top = {0.2F, 0.4F, 0.6F};
        other.annotations.title = "Next";
    }

    Primitives& add(Frame& to, const Shape& shape, float opacity) {
        to.primitives.push_back(shape.primitives());
        to.primitives.back().identity = ++identity;
        to.primitives.back().revision = identity;
        to.primitives.back().color[3] = opacity;
        return to.primitives.back();
    }
    void add_lines_and_points(Frame& to, float opacity) {
        add(to, lines, opacity).lines = true;
        add(to, corners, opacity).points = true;
    }
    // Draws `frame` and abandons it at call `questions` (from 0) of check_wanted. False when the picture was finished
    // before.
    bool give_up_after(int questions) {
        frame.check_wanted = [&] {
            if (--questions < 0) throw Unwanted();
        };
        try {
            (void)painter->draw(frame, {});
            return false;
        } catch (const Unwanted&) {
            return true;
        }
    }
    Image picture_of(Frame& wanted) {
        wanted.check_wanted = nullptr;
        return painter->draw(wanted, {});
    }
    // Abandons `frame` at each call of check_wanted in turn, then compares the next picture with a fresh painter's.
    // That is `frame` or `other`, alternating.
    void expect_no_trace(const char* what, int fewest_places) {
        SCOPED_TRACE(what);
        Painter fresh(Gl::load(chosen.context->loader()));
        frame.check_wanted = other.check_wanted = nullptr;
        const Image same = fresh.draw(frame, {}), next = fresh.draw(other, {});
        const auto expect_same = [this](Frame& wanted, const Image& before, int places) {
            EXPECT_TRUE(picture_of(wanted).rgb == before.rgb) << "given up at " << places;
        };
        int places = 0;
        for (; give_up_after(places) && !HasFailure(); ++places) {
            if (places % 2 == 0)
                expect_same(other, next, places);
            else
                expect_same(frame, same, places);
        }
        EXPECT_GE(places, fewest_places);
        Vec3d position{};
        give_up_after(0);
        EXPECT_FALSE(painter->pick(24, 24, position)) << "of a picture that there is not";
        EXPECT_EQ(Gl::load(chosen.context->loader()).GetError(), static_cast<GLenum>(GL_NO_ERROR));
    }

    ChosenContext chosen;
    std::optional<Painter> painter;
    Frame frame, other;
    std::uint64_t identity = 0;
    Shape ball = sphere(0.6), plane = square(0.3), small = sphere(0.3, {0.2, 0, 0}, 12);
    Shape lines{{{-1, 0, -1}, {1, 0, 1}, {-1, -0.5F, 1}}, {}, {}, {0, 1, 1, 2}};
    Shape corners{{{-1, 0, -1}, {1, 0, 1}, {-1, -0.5F, 1}}, {}, {}, {0, 1, 2}};
};

INSTANTIATE_TEST_SUITE_P(Backends, GivenUpTest, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GivenUpTest);

TEST_P(GivenUpTest, OpaqueAndSortedTransparentSurfaces) {
    add(frame, ball, 1);
    add_lines_and_points(frame, 1);
    add(frame, plane, 0.5F);
    add(other, small, 1);
    add(other, plane, 0.5F);
    add_lines_and_points(other, 1);
    expect_no_trace("moving", 12);
}

TEST_P(GivenUpTest, LayersOfAStill) {
    add(frame, plane, 1);
    add(frame, ball, 0.5F);
    add_lines_and_points(frame, 0.5F);
    add(other, small, 0.5F);
    add_lines_and_points(other, 0.5F);
    frame.samples = 4;
    expect_no_trace("before a moving picture", 20);
    std::swap(frame.samples, other.samples);
    expect_no_trace("before a still", 20);
}

TEST_P(GivenUpTest, VolumesAmongSurfaces) {
    VolumeScene warm(test::hexahedra({{3, 3, 3}, 0, 1, 1.0 / 3}), [](const Vec3d& p) { return p[0]; });
    VolumeScene cold(test::hexahedra({{3, 3, 3}, -0.5, 1, 1.0 / 3}), [](const Vec3d& p) { return p[2]; });
    frame.volumes = {warm.volume({0, 1, 0}, 3), cold.volume({0, 1, 0}, 2)};
    frame.volumes[1].identity = 2;
    other.volumes = {frame.volumes[1]};
    add(frame, plane, 1);
    add(frame, small, 0.5F);
    add_lines_and_points(frame, 1);
    add(other, small, 1);
    frame.samples = 4;
    expect_no_trace("still", 80);
    frame.samples = 1;
    frame.volumes.pop_back();
    frame.volumes[0].stride = 3;
    frame.volumes[0].coarseness = 2;
    expect_no_trace("moving", 30);
}

TEST_P(GivenUpTest, NobodyIsAskedAfterThePicture) {
    add(frame, ball, 0.5F);
    frame.samples = 4;
    bool done = false;
    frame.check_wanted = [&] {
        if (done) throw Unwanted();
    };
    (void)painter->draw(frame, {});
    done = true;
    Vec3d position{};
    EXPECT_TRUE(painter->pick(24, 24, position));
}

class GivenUpUploadTest : public GivenUpTest {
protected:
    static constexpr int layers = 40;
    void add_layers(bool points) {
        for (int i = 0; i < layers; ++i) add(frame, ball, 0.5F).points = points;
    }
    // Bytes sent to buffers before the picture was abandoned at call `questions` of check_wanted.
    std::size_t sent_before(int questions) {
        (void)take_counts();
        EXPECT_TRUE(give_up_after(questions));
        return take_counts().bytes;
    }
};

INSTANTIATE_TEST_SUITE_P(Backends, GivenUpUploadTest, testing::ValuesIn(available_backends()), name_of_test);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GivenUpUploadTest);

TEST_P(GivenUpUploadTest, TransparentTriangles) {
    add_layers(false);
    std::size_t whole = 0; // bytes sent for a complete picture
    (void)take_counts();
    (void)picture_of(frame);
    whole = take_counts().bytes;
    for (Primitives& primitives : frame.primitives) primitives.revision += layers; // marks all layers as changed
    EXPECT_EQ(sent_before(layers), 0U) << "the layers are gathered one by one";
    int places = layers;
    while (sent_before(places) == 0 && places < 100 * layers) ++places;
    EXPECT_LT(sent_before(places), whole / 2) << "the vertices go up in pieces";
    EXPECT_LT(sent_before(places + 1), whole);
}

TEST_P(GivenUpUploadTest, TransparentPoints) {
    add_layers(true);
    EXPECT_EQ(sent_before(layers), 0U) << "the layers are gathered one by one";
}

TEST_P(GivenUpUploadTest, AnOpaqueMesh) {
    const Shape fine = sphere(0.6, {}, 1200); // 8.6 MB of positions
    add(frame, fine, 1);
    int places = 0;
    while (sent_before(places) == 0) ++places;
    EXPECT_LT(sent_before(places), fine.positions.size() * sizeof(Vec3f));
    frame.check_wanted = nullptr;
    Painter fresh(Gl::load(chosen.context->loader()));
    const Image whole = fresh.draw(frame, {});
    EXPECT_TRUE(picture_of(frame).rgb == whole.rgb) << "half a mesh is not taken for the mesh";
}

TEST_P(GivenUpUploadTest, TheOrderOfATurnedView) {
    add_layers(false);
    for (Primitives& primitives : frame.primitives)
        primitives.color[0] = 0.02F * static_cast<float>(primitives.identity);
    add(frame, plane, 0.5F);
    (void)picture_of(frame);
    std::swap(frame.camera.position[0], frame.camera.position[1]);
    Painter fresh(Gl::load(chosen.context->loader()));
    const Image turned = fresh.draw(frame, {});
    for (int places = 1; places < layers; places += 3) {
        ASSERT_TRUE(give_up_after(places));
        EXPECT_TRUE(picture_of(frame).rgb == turned.rgb) << "given up at " << places;
        std::swap(frame.camera.position[0], frame.camera.position[1]);
        (void)picture_of(frame);
        std::swap(frame.camera.position[0], frame.camera.position[1]);
    }
}

// With check_wanted the painter draws in smaller parts. The picture is the same, and nothing is allocated or sent.
TEST_P(GivenUpTest, NothingIsMadeOrSentForTheQuestions) {
    add(frame, ball, 0.5F);
    add(frame, plane, 1);
    add_lines_and_points(frame, 1);
    frame.samples = 4;
    int questions = 0;
    const Image whole = picture_of(frame);
    for (int i = 0; i < 2; ++i) {
        frame.check_wanted = [&] { ++questions; };
        (void)take_counts();
        const Image divided = painter->draw(frame, {});
        const GlCounts counts = take_counts();
        EXPECT_EQ(divided.rgb, whole.rgb);
        EXPECT_EQ(counts.objects, 0);
        EXPECT_EQ(counts.storage, 0);
        EXPECT_EQ(counts.bytes, 0U);
    }
    EXPECT_GT(questions, 20);
}

} // namespace
} // namespace server::render
