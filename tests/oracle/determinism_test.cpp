// Bit-identical results for any algorithm, block size, number of threads and history of calls.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

constexpr bool with_normals = true;

class Determinism : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {16}};

    static std::vector<Surface> surfaces(Query& query, const std::vector<double>& walk) {
        std::vector<Surface> result(walk.size());
        for (std::size_t i = 0; i < walk.size(); ++i) EXPECT_TRUE(query.extract(walk[i], with_normals, result[i]));
        return result;
    }
};

TEST_P(Determinism, BothAlgorithmsGiveTheSameBitsAfterAnyWalk) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query signatures = mesh.query(Algorithm::signatures), propagation = mesh.query(Algorithm::propagation);
        signatures.set_field(field);
        propagation.set_field(field);
        for (double nu : walk_through(values, 20, 101)) {
            Surface a, b;
            ASSERT_TRUE(signatures.extract(nu, with_normals, a));
            ASSERT_TRUE(propagation.extract(nu, with_normals, b));
            ASSERT_EQ(bit_difference(a, b), "") << named.name << " at " << nu;
        }
    }
}

TEST_P(Determinism, AWalkEndsWhereAFreshQueryStarts) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
            Query walked = mesh.query(algorithm);
            walked.set_field(field);
            for (double nu : walk_through(values, 10, 102)) {
                Query fresh = mesh.query(algorithm);
                fresh.set_field(field);
                Surface a, b;
                ASSERT_TRUE(walked.extract(nu, with_normals, a));
                ASSERT_TRUE(fresh.extract(nu, with_normals, b));
                ASSERT_EQ(bit_difference(a, b), "") << named.name << " at " << nu;
            }
        }
    }
}

TEST_P(Determinism, BlockSizesDoNotShow) {
    for (std::size_t f : {0U, 3U, 7U}) {
        const std::vector<float> values = all_fields()[f].make(input);
        const std::vector<double> walk = walk_through(values, 8, 103);
        std::vector<Surface> expected;
        for (Index cells_per_block : {1U, 7U, 64U, 256U, 4096U}) {
            const KernelMesh other(input, {cells_per_block});
            const Field field = make_field(other.topology, other.stored(values));
            for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
                Query query = other.query(algorithm);
                query.set_field(field);
                const std::vector<Surface> found = surfaces(query, walk);
                if (expected.empty()) expected = found;
                for (std::size_t i = 0; i < walk.size(); ++i) {
                    ASSERT_EQ(bit_difference(expected[i], found[i], Chunks::ignore), "")
                        << all_fields()[f].name << " at " << walk[i] << " with " << cells_per_block
                        << " cells per block";
                }
            }
        }
    }
}

TEST_P(Determinism, ThreadsDoNotShow) {
    const std::vector<float> values = random_field(input.vertex_count(), 104);
    const std::vector<double> walk = walk_through(values, 8, 105);
    std::vector<Surface> expected;
    for (unsigned threads : {1U, 2U, 5U}) {
        const ThreadCount count(threads);
        const KernelMesh other(input, {4});
        const Field field = make_field(other.topology, other.stored(values));
        for (Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
            Query query = other.query(algorithm);
            query.set_field(field);
            const std::vector<Surface> found = surfaces(query, walk);
            if (expected.empty()) expected = found;
            for (std::size_t i = 0; i < walk.size(); ++i) {
                ASSERT_EQ(bit_difference(expected[i], found[i]), "") << walk[i] << " with " << threads << " threads";
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Determinism, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// Enough cells for the parallel loops to split.
TEST(DeterminismLarge, ThreadsDoNotShow) {
    const Polyhedra input = zoo({{14, 14, 14}, 0.1, 106});
    const std::vector<float> values = bumps_field(input, 107);
    Surface expected;
    for (unsigned threads : {1U, 2U, 5U}) {
        const ThreadCount count(threads);
        const KernelMesh mesh(input, {64});
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        Surface found;
        for (double nu : {0.4, 0.7, 0.6}) ASSERT_TRUE(query.extract(nu, with_normals, found));
        ASSERT_GT(found.polygon_cell.size(), 500U);
        if (threads == 1) expected = found;
        EXPECT_EQ(bit_difference(expected, found), "") << threads;
    }
}

} // namespace
} // namespace ciel::test
