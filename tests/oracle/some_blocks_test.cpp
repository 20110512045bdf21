// Surfaces of some of the blocks of a mesh equal the surface of all blocks without the polygons of the others.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace ciel::test {
namespace {

// Returns the mesh edges of all points that polygons of other blocks use, sorted.
std::vector<std::array<Index, 2>> shared_edges(const Surface& all, const std::vector<Index>& blocks) {
    std::vector<std::array<Index, 2>> shared;
    for (const Surface::Chunk& chunk : all.chunks)
        if (!std::ranges::binary_search(blocks, chunk.block))
            for (Index i = chunk.polygon_begin; i < chunk.polygon_end; ++i)
                for (const Index p : polygon(all, i)) shared.push_back({all.points[p].a, all.points[p].b});
    std::ranges::sort(shared);
    return shared;
}

std::vector<Index> random_blocks(Index count, double share, std::mt19937& random) {
    std::vector<Index> blocks;
    for (Index b = 0; b < count; ++b)
        if (std::uniform_real_distribution<>(0, 1)(random) < share) blocks.push_back(b);
    return blocks;
}

class SomeBlocks : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {4}};
};

TEST_P(SomeBlocks, HaveTheSurfaceOfAllWithoutTheOthers) {
    std::mt19937 random(401);
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::naive, Algorithm::propagation}) {
            Query whole = mesh.query(), part = mesh.query(algorithm);
            whole.set_field(field);
            part.set_field(field);
            for (const double nu : walk_through(values, 4, 402))
                for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
                    const std::vector<Index> blocks = random_blocks(mesh.topology.block_count(), share, random);
                    part.set_blocks(blocks);
                    Surface all, some;
                    ASSERT_TRUE(whole.extract(nu, false, all));
                    ASSERT_TRUE(part.extract(nu, false, some));
                    ASSERT_EQ(bit_difference(only(all, blocks), some), "") << named.name << " at " << nu;
                }
            part.set_blocks({});
            Surface all, again;
            ASSERT_TRUE(whole.extract(0.5, true, all));
            ASSERT_TRUE(part.extract(0.5, true, again));
            ASSERT_EQ(bit_difference(all, again), "") << named.name;
        }
    }
}

// Normals from gradients are the same, because gradients use the cells of all blocks. Normals from polygons use only
// the polygons of the extracted blocks, so they differ at points that a left-out block shares.
TEST_P(SomeBlocks, HaveTheNormalsOfAll) {
    std::mt19937 random(403);
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const std::vector<double> walk = walk_through(values, 3, 404);
        for (const double share : {0.2, 0.7})
            for (const double nu : walk) {
                // Two new fields, so that neither query uses gradients computed for the other.
                const Field of_whole = make_field(mesh.topology, mesh.stored(values));
                const Field of_part = make_field(mesh.topology, mesh.stored(values));
                const std::vector<Index> blocks = random_blocks(mesh.topology.block_count(), share, random);
                Query whole = mesh.query(), part = mesh.query();
                whole.set_field(of_whole);
                part.set_field(of_part);
                part.set_blocks(blocks);
                for (const Normals normals : {Normals::gradient, Normals::polygons}) {
                    whole.set_normals(normals);
                    part.set_normals(normals);
                    Surface all, some;
                    ASSERT_TRUE(whole.extract(nu, true, all));
                    ASSERT_TRUE(part.extract(nu, true, some));
                    ASSERT_EQ(broken_promise(some, mesh, mesh.stored(values), nu, true), "") << named.name;
                    const Surface expected = only(all, blocks);
                    const auto shared = shared_edges(all, blocks);
                    ASSERT_EQ(some.normals.size(), expected.normals.size());
                    for (std::size_t p = 0; p < some.normals.size(); ++p) {
                        if (std::ranges::binary_search(shared, std::array{some.points[p].a, some.points[p].b}))
                            continue;
                        ASSERT_EQ(some.normals[p], expected.normals[p]) << named.name << " at " << nu;
                    }
                }
            }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SomeBlocks, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// The surfaces of three disjoint sets of blocks make up the whole surface.
TEST(SomeBlocksTogether, AreTheWholeSurface) {
    const Polyhedra input = zoo({{8, 8, 8}, 0.1, 405});
    const KernelMesh mesh(input, {32});
    const std::vector<float> stored = mesh.stored(bumps_field(input, 406));
    const Field field = make_field(mesh.topology, stored);
    Query query = mesh.query();
    query.set_field(field);
    Surface all;
    ASSERT_TRUE(query.extract(0.5, true, all));
    std::map<std::array<Index, 2>, std::pair<Vec3f, Vec3f>> point_of_edge;
    for (std::size_t p = 0; p < all.points.size(); ++p)
        point_of_edge[{all.points[p].a, all.points[p].b}] = {all.positions[p], all.normals[p]};
    std::size_t polygons = 0, points = 0, equal_normals = 0;
    for (Index part = 0; part < 3; ++part) {
        std::vector<Index> blocks;
        for (Index b = part; b < mesh.topology.block_count(); b += 3) blocks.push_back(b);
        query.set_blocks(blocks);
        Surface some;
        ASSERT_TRUE(query.extract(0.5, true, some));
        polygons += some.polygon_cell.size();
        points += some.points.size();
        for (std::size_t p = 0; p < some.points.size(); ++p) {
            const auto& [position, normal] = point_of_edge.at({some.points[p].a, some.points[p].b});
            ASSERT_EQ(some.positions[p], position);
            if (some.normals[p] == normal) ++equal_normals;
        }
    }
    EXPECT_EQ(polygons, all.polygon_cell.size());
    EXPECT_GT(points, all.points.size());           // points between parts are in several
    EXPECT_GT(equal_normals, points - points / 20); // others come from polygons instead of gradients
}

TEST(SomeBlocksTogether, ABlockThatTheMeshDoesNotHaveIsRefused) {
    const KernelMesh mesh(hexahedra({{2, 2, 2}}), {4});
    Query query = mesh.query();
    try {
        query.set_blocks(std::array<Index, 2>{1, 2});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "the mesh has no block 2; it has the blocks 0 to 1");
    }
}

} // namespace
} // namespace ciel::test
