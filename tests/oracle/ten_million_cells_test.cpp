// A mesh of ten million cells, for errors that need large ids or much memory.
#include "ciel/extract.hpp"
#include "support/kept.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

constexpr Index n = 216; // cells along an edge of the unit cube
constexpr Index corners = n + 1;

// n x n x n hexahedra in row order, written directly as a FaceMesh. Each face is stored with its first cell.
class CubeOfCells {
public:
    CubeOfCells() : number_(std::size_t{corners} * corners * corners, none) {
        mesh_.face_vertex.reserve(std::size_t{12} * n * n * corners);
        for (Index z = 0; z < n; ++z)
            for (Index y = 0; y < n; ++y)
                for (Index x = 0; x < n; ++x) add_cell(x, y, z);
        mesh_.cell_types.assign(std::size_t{n} * n * n, 12);
    }
    FaceMesh mesh_;

private:
    using Corner = std::array<Index, 3>;

    Index vertex(const Corner& at) {
        Index& id = number_[(std::size_t{at[2]} * corners + at[1]) * corners + at[0]];
        if (id == none) {
            id = static_cast<Index>(mesh_.positions.size() / 3);
            for (const Index i : at) mesh_.positions.push_back(static_cast<float>(i) / n);
        }
        return id;
    }
    void add_face(Index owner, Index neighbour, const std::array<Corner, 4>& loop) {
        for (const Corner& corner : loop) mesh_.face_vertex.push_back(vertex(corner));
        mesh_.face_offset.push_back(mesh_.face_vertex.size());
        mesh_.owner.push_back(owner);
        mesh_.neighbour.push_back(neighbour);
    }
    void add_cell(Index x, Index y, Index z) {
        const Index cell = (z * n + y) * n + x, u = x + 1, v = y + 1, w = z + 1;
        if (x == 0) add_face(cell, none, {{{x, y, z}, {x, y, w}, {x, v, w}, {x, v, z}}});
        if (y == 0) add_face(cell, none, {{{x, y, z}, {u, y, z}, {u, y, w}, {x, y, w}}});
        if (z == 0) add_face(cell, none, {{{x, y, z}, {x, v, z}, {u, v, z}, {u, y, z}}});
        add_face(cell, u == n ? none : cell + 1, {{{u, y, z}, {u, v, z}, {u, v, w}, {u, y, w}}});
        add_face(cell, v == n ? none : cell + n, {{{x, v, z}, {x, v, w}, {u, v, w}, {u, v, z}}});
        add_face(cell, w == n ? none : cell + n * n, {{{x, y, w}, {u, y, w}, {u, v, w}, {x, v, w}}});
    }

    std::vector<Index> number_;
};

std::int64_t euler_characteristic(const Surface& closed) {
    return static_cast<std::int64_t>(closed.points.size()) -
           static_cast<std::int64_t>(closed.polygon_vertex.size() / 2) +
           static_cast<std::int64_t>(closed.polygon_cell.size());
}

TEST(TenMillionCells, AreBuiltSlicedAndContoured) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "needs several times the memory under a sanitizer";
#endif
    const CubeOfCells cube;
    const FaceMeshView mesh = kept(cube.mesh_.view());
    const Topology topology(mesh);
    const std::uint64_t cells = std::uint64_t{n} * n * n, faces = std::uint64_t{3} * n * n * corners;
    EXPECT_GT(cells, 10'000'000U);
    EXPECT_EQ(topology.counts().cells, cells);
    EXPECT_EQ(topology.counts().vertices, std::uint64_t{corners} * corners * corners);
    EXPECT_EQ(topology.counts().edges, std::uint64_t{3} * n * corners * corners);
    EXPECT_EQ(topology.counts().faces, faces);
    EXPECT_EQ(topology.counts().boundary_faces, std::uint64_t{6} * n * n);
    EXPECT_EQ(topology.counts().half_edges, 24 * cells);
    EXPECT_EQ(topology.counts().components, 1U);
    // Row order gives flat blocks with large borders. Cells along a space-filling curve need less memory.
    EXPECT_LT(topology.memory_bytes(), 5 * 24 * cells);

    std::vector<float> height(mesh.vertex_count()), distance(mesh.vertex_count());
    for (std::size_t v = 0; v < height.size(); ++v) {
        const float* at = &mesh.positions.floats()[3 * v];
        height[v] = at[2];
        distance[v] = std::hypot(at[0] - 0.5F, at[1] - 0.5F, at[2] - 0.5F);
    }
    Query query(topology, mesh, {});
    const Field slice(topology, height, kept_by_test), sphere(topology, distance, kept_by_test);
    Surface surface;
    query.set_field(slice);
    ASSERT_TRUE(query.extract(0.37, false, surface));
    EXPECT_EQ(surface.polygon_cell.size(), std::size_t{n} * n);
    EXPECT_EQ(surface.points.size(), std::size_t{corners} * corners);
    for (const Vec3f& p : surface.positions) ASSERT_NEAR(p[2], 0.37, 1e-6);

    query.set_field(sphere);
    ASSERT_TRUE(query.extract(0.4, true, surface));
    EXPECT_EQ(euler_characteristic(surface), 2);
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            ASSERT_NEAR(surface.normals[i][axis], (surface.positions[i][axis] - 0.5) / 0.4, 0.01);
}

} // namespace
} // namespace ciel::test
