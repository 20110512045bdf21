// A shape that its last owner has released gives its buffers to the next surface.
#include "ciel/assemble.hpp"
#include "geometry/cut.hpp"
#include "support/kept.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace server::geometry {
using namespace ciel;
namespace {

TEST(ShapePool, GivesBuffersAgain) {
    const auto pool = ShapePool::make();
    auto first = pool->take();
    first->surface.positions.resize(1000);
    const Vec3f* buffer = first->surface.positions.data();
    first = nullptr;
    EXPECT_GE(pool->memory_bytes(), 1000 * sizeof(Vec3f));
    EXPECT_EQ(pool->take()->surface.positions.data(), buffer);
    pool->forget();
    EXPECT_EQ(pool->memory_bytes(), 0U);
    EXPECT_TRUE(pool->take()->surface.positions.empty());
}

TEST(ShapePool, LeavesAloneWhatIsHeld) {
    const auto pool = ShapePool::make();
    const std::shared_ptr<const Shape> held = pool->take();
    const auto other = pool->take();
    EXPECT_NE(held.get(), other.get());
}

TEST(ShapePool, MayGoFirst) {
    auto pool = ShapePool::make();
    const auto held = pool->take();
    pool = nullptr;
    held->surface.positions.resize(10);
}

// A picture in progress may release a shape on another thread.
TEST(ShapePool, TakesThemBackFromAnyThread) {
    const auto pool = ShapePool::make();
    for (int i = 0; i < 200; ++i) {
        std::shared_ptr<Shape> shape = pool->take();
        shape->indices.assign(100, static_cast<Index>(i));
        std::thread other([held = std::shared_ptr<const Shape>(shape)] { EXPECT_EQ(held->indices.size(), 100U); });
        shape = nullptr;
        other.join();
    }
}

// Moves the iso-value to and fro in one tetrahedron.
TEST(Cut, MovesWithoutNewBuffers) {
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    PolyhedraView input;
    const std::vector<std::uint8_t> types{10};
    const std::vector<std::uint64_t> cells{0, 4}, faces{0, 3, 6, 9, 12};
    const std::vector<Index> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    input.positions = positions;
    input.cell_types = types;
    input.cell_offset = cells;
    input.face_offset = faces;
    input.face_vertex = corners;
    const Assembled assembled = assemble(input);
    const auto topology = std::make_shared<const Topology>(assembled.mesh.view());
    const std::vector<float> values{0, 1, 2, 3};
    Cut cut;
    cut.use_field("f",
                  {topology,
                   std::make_shared<const Field>(*topology, values, test::kept_by_test),
                   test::kept(assembled.mesh.view()),
                   {},
                   0},
                  {});
    ASSERT_TRUE(cut.extract(0.5, true, {}));
    const Vec3f* const buffer = cut.shape->surface.positions.data();
    const Index* const indices = cut.shape->indices.data();
    for (const double nu : {0.6, 0.7, 0.5, 0.4}) {
        ASSERT_TRUE(cut.extract(nu, true, {}));
        EXPECT_EQ(cut.shape->surface.positions.size(), 3U);
        EXPECT_EQ(cut.shape->surface.positions.data(), buffer);
        EXPECT_EQ(cut.shape->indices.data(), indices);
    }
}

} // namespace
} // namespace server::geometry
