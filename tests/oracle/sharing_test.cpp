// One topology and one field shared by many queries, interrupted calls, and vertices that move.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <thread>

namespace ciel::test {
namespace {

class Sharing : public testing::TestWithParam<Algorithm> {
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

// Minima and gradients are computed on demand, by the first thread that needs them.
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

// An interrupted call must leave the query unchanged, wherever the stop comes. Calls repeat until the stop interrupts
// one, for any timing of the threads.
TEST_P(Sharing, ACallStoppedAnywhereHarmsNothing) {
    using std::chrono::steady_clock;
    const Field field = make_field(mesh.topology, mesh.stored(values));
    const double nus[] = {0.3, 0.7};
    const Surface expected[] = {fresh(field, nus[0]), fresh(field, nus[1])};
    Query query = mesh.query(GetParam());
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(nus[1], true, surface));
    const auto before = steady_clock::now();
    ASSERT_TRUE(query.extract(nus[0], true, surface));
    const auto one_call = steady_clock::now() - before;
    int stopped_inside = 0;
    for (int round = 0; round < 60; ++round) {
        std::stop_source stop;
        std::atomic<steady_clock::time_point> due = steady_clock::time_point::max();
        std::latch watching(1);
        std::jthread stopper([&] {
            watching.count_down();
            while (steady_clock::now() < due.load()) std::this_thread::yield();
            stop.request_stop();
        });
        watching.wait();
        due = steady_clock::now() + round * one_call / 16;
        bool done = true;
        for (std::size_t call = 0; done && call < 2000; ++call) {
            const bool too_late = stop.stop_requested();
            done = query.extract(nus[call % 2], true, surface, stop.get_token());
            ASSERT_EQ(done ? bit_difference(surface, expected[call % 2]) : "", "") << "call " << call;
            stopped_inside += done || too_late ? 0 : 1;
        }
        stopper.join();
        ASSERT_FALSE(done) << "round " << round;
        ASSERT_TRUE(query.extract(nus[1], true, surface));
        ASSERT_EQ(bit_difference(surface, expected[1]), "") << "after round " << round;
    }
    EXPECT_GE(stopped_inside, 20);
}

// Moving the vertices keeps the topology: the polygons are the same at other positions.
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

INSTANTIATE_TEST_SUITE_P(Algorithms, Sharing, testing::Values(Algorithm::signatures, Algorithm::propagation),
                         [](const auto& test) {
                             return test.param == Algorithm::signatures ? "signatures" : "propagation";
                         });

} // namespace
} // namespace ciel::test
