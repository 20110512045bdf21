// One topology and one field under many queries, calls cut short, and vertices that move.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace ciel::test {
namespace {

class Sharing : public testing::TestWithParam<Engine> {
protected:
    const Polyhedra input = zoo({{9, 9, 9}, 0.1, 151});
    const KernelMesh mesh{input, {32}};
    const std::vector<float> values = random_field(input.vertex_count(), 152);

    Surface fresh(const Field& field, double nu) const {
        Query query = mesh.query(GetParam());
        query.set_field(field);
        Surface surface;
        EXPECT_TRUE(query.extract(nu, true, surface));
        return surface;
    }
};

// Minima and gradients are made on demand, by whichever session comes first.
TEST_P(Sharing, QueriesInManyThreadsGiveTheSameBits) {
    const std::vector<double> walk = walk_through(values, 12, 153);
    std::vector<Surface> expected;
    const Field alone = make_field(mesh.topology, mesh.stored(values));
    for (double nu : walk) expected.push_back(fresh(alone, nu));
    const Field shared = make_field(mesh.topology, mesh.stored(values));
    std::atomic<int> different = 0;
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 4; ++first) {
        threads.emplace_back([&, first] {
            Query query = mesh.query(GetParam());
            query.set_field(shared);
            for (std::size_t i = 0; i < walk.size(); ++i) {
                const std::size_t at = (i + 5 * first) % walk.size();
                Surface surface;
                if (!query.extract(walk[at], true, surface) || !bit_difference(surface, expected[at]).empty())
                    ++different;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(different, 0);
}

// Whenever the stop comes, the query goes on as if the call had not been made.
TEST_P(Sharing, ACallStoppedAnywhereHarmsNothing) {
    const Field field = make_field(mesh.topology, mesh.stored(values));
    const Surface expected_low = fresh(field, 0.3), expected_high = fresh(field, 0.7);
    Query query = mesh.query(GetParam());
    query.set_field(field);
    for (int delay = 0; delay < 60; ++delay) {
        std::stop_source stop;
        std::thread stopper([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(20 * delay));
            stop.request_stop();
        });
        Surface surface;
        const bool done = query.extract(0.3, true, surface, stop.get_token());
        EXPECT_EQ(done ? bit_difference(surface, expected_low) : "", "");
        stopper.join();
        ASSERT_TRUE(query.extract(0.7, true, surface));
        ASSERT_EQ(bit_difference(surface, expected_high), "") << "after a stop at " << delay;
    }
}

// A moved mesh keeps its topology: the polygons stay, their vertices follow.
TEST_P(Sharing, VerticesMayMoveUnderATopology) {
    const Field field = make_field(mesh.topology, mesh.stored(values));
    const Surface before = fresh(field, 0.5);
    std::vector<float> moved(mesh.mesh().positions.begin(), mesh.mesh().positions.end());
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = 2 * moved[i] + static_cast<float>(i % 3);
    FaceMeshView view = mesh.mesh();
    view.positions = moved;
    Query query(mesh.topology, view, GetParam());
    query.set_field(field);
    Surface after;
    ASSERT_TRUE(query.extract(0.5, false, after));
    EXPECT_EQ(after.polygon_vertex, before.polygon_vertex);
    EXPECT_EQ(after.polygon_cell, before.polygon_cell);
    ASSERT_EQ(after.positions.size(), before.positions.size());
    for (std::size_t i = 0; i < after.positions.size(); ++i) {
        for (std::size_t d = 0; d < 3; ++d) {
            ASSERT_NEAR(after.positions[i][d], 2 * before.positions[i][d] + static_cast<float>(d), 1e-5);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Engines, Sharing, testing::Values(Engine::signatures, Engine::propagation),
                         [](const auto& test) {
                             return test.param == Engine::signatures ? "signatures" : "propagation";
                         });

} // namespace
} // namespace ciel::test
