// Least-squares matrices that fields share (CellFits), and gradients that are solved four cells at a time: both give
// the same bits as without.
#include "ciel/contour.hpp"
#include "fields/many_gradients.hpp"
#include "oracle/kernel_mesh.hpp"
#include "oracle/random_cells.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace ciel::test {

using namespace ciel::detail;

namespace {

class SharedFits : public testing::TestWithParam<NamedMesh> {
protected:
    // Returns a field of random values, as floats or as doubles.
    [[nodiscard]] Field field(const KernelMesh& mesh, std::uint64_t seed, bool doubles) const {
        std::vector<float> values = mesh.stored(random_field(input.vertex_count(), seed));
        if (seed % 2 == 1)
            for (std::size_t v = 0; v < values.size(); v += 37) values[v] = std::nanf("");
        if (!doubles) return make_field(mesh.topology, values);
        auto kept = std::make_shared<std::vector<double>>(values.begin(), values.end());
        for (double& value : *kept) value += 1e-9 * value * value;
        return {mesh.topology, *kept, kept};
    }
    // Returns the surfaces of a field at three values.
    [[nodiscard]] static std::vector<Surface> surfaces(const KernelMesh& mesh, const Field& of) {
        std::vector<Surface> found;
        Query query = mesh.query();
        query.set_field(of);
        for (const double nu : {0.35, 0.7, 0.5}) (void)query.extract(nu, true, found.emplace_back());
        return found;
    }
    static void expect_same(const std::vector<Surface>& expected, const std::vector<Surface>& found) {
        ASSERT_EQ(expected.size(), found.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(bit_difference(expected[i], found[i]), "") << i;
    }
    [[nodiscard]] static bool has_polyhedra(const KernelMesh& mesh) {
        return std::ranges::count(mesh.mesh().cell_types, static_cast<std::uint8_t>(CellType::polyhedron)) > 0;
    }

    Polyhedra input = GetParam().make();
};

TEST_P(SharedFits, GiveTheSameBits) {
    for (const Index cells_per_block : {5U, 64U, 4096U})
        for (const std::size_t most_bytes : {std::numeric_limits<std::size_t>::max(), std::size_t{1}, std::size_t{0}}) {
            const KernelMesh mesh(input, {cells_per_block});
            const auto fits = std::make_shared<CellFits>(mesh.topology, most_bytes);
            for (const bool doubles : {false, true, false}) {
                const Field alone = field(mesh, 31, doubles);
                Field sharing = field(mesh, 31, doubles);
                sharing.set_cell_fits(fits);
                expect_same(surfaces(mesh, alone), surfaces(mesh, sharing));
            }
        }
}

TEST_P(SharedFits, AreMadeOnce) {
    const KernelMesh mesh(input);
    const auto fits = std::make_shared<CellFits>(mesh.topology);
    const std::size_t empty = fits->memory_bytes();
    std::size_t bytes = empty;
    for (int i = 0; i < 2; ++i) {
        Field sharing = field(mesh, 31, false);
        sharing.set_cell_fits(fits);
        const bool cuts = !surfaces(mesh, sharing).back().points.empty();
        EXPECT_TRUE(i == 0 || fits->memory_bytes() == bytes);
        bytes = fits->memory_bytes();
        EXPECT_TRUE(bytes > empty || !cuts || !has_polyhedra(mesh));
    }
}

TEST_P(SharedFits, ServeThreadsAtTheSameTime) {
    const ThreadCount count(2);
    const KernelMesh mesh(input, {32});
    const auto fits = std::make_shared<CellFits>(mesh.topology);
    std::vector<std::future<std::vector<Surface>>> found;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        found.push_back(std::async(std::launch::async, [&, seed] {
            Field sharing = field(mesh, seed, false);
            sharing.set_cell_fits(fits);
            return surfaces(mesh, sharing);
        }));
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        expect_same(surfaces(mesh, field(mesh, seed, false)), found[seed - 1].get());
}

// The positions change in place, so their address does not show that the vertices have moved.
TEST_P(SharedFits, AreDroppedWhenVerticesMove) {
    const KernelMesh mesh(input);
    std::vector<float> positions(mesh.assembled.mesh.positions);
    FaceMeshView moving = mesh.mesh();
    moving.positions = positions;
    Field sharing = field(mesh, 31, false);
    sharing.set_cell_fits(std::make_shared<CellFits>(mesh.topology));
    const auto cut = [&](const Field& of) {
        Surface surface;
        Query query(mesh.topology, moving);
        query.set_field(of);
        (void)query.extract(0.5, true, surface);
        return surface;
    };
    (void)cut(sharing);
    for (std::size_t i = 0; i < positions.size(); i += 3) positions[i] *= 3;
    sharing.vertices_moved();
    EXPECT_EQ(bit_difference(cut(field(mesh, 31, false)), cut(sharing)), "");
}

INSTANTIATE_TEST_SUITE_P(Meshes, SharedFits, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

TEST(SharedFitsOf, AnotherMeshAreRefusedOrNotUsed) {
    const KernelMesh mesh(voronoi(100, 3)), other(voronoi(100, 4));
    const std::vector<float> values = random_field(mesh.topology.counts().vertices, 5);
    Field field = make_field(mesh.topology, values);
    EXPECT_THROW(field.set_cell_fits(std::make_shared<CellFits>(other.topology)), Error);

    // The fits are for the positions at which the first field was cut. A field at other positions must not use them.
    const auto fits = std::make_shared<CellFits>(mesh.topology);
    std::vector<float> moved(mesh.assembled.mesh.positions);
    for (std::size_t i = 0; i < moved.size(); i += 3) moved[i] *= 3;
    FaceMeshView there = mesh.mesh();
    there.positions = moved;
    const auto normals = [&](const FaceMeshView& at, const std::shared_ptr<CellFits>& shared) {
        Field cut = make_field(mesh.topology, values);
        cut.set_cell_fits(shared);
        Query query(mesh.topology, at);
        query.set_field(cut);
        Surface surface;
        (void)query.extract(0.5, true, surface);
        return surface.normals;
    };
    (void)normals(mesh.mesh(), fits);
    EXPECT_EQ(normals(there, fits), normals(there, nullptr));

    const std::size_t bytes = fits->memory_bytes();
    fits->forget();
    EXPECT_LT(fits->memory_bytes(), bytes);
    const std::size_t forgotten = fits->memory_bytes();
    EXPECT_EQ(normals(mesh.mesh(), fits), normals(mesh.mesh(), nullptr));
    EXPECT_EQ(fits->memory_bytes(), forgotten);
}

class ManyGradients : public testing::TestWithParam<CellType> {
protected:
    static constexpr std::size_t cells = 4099;
    RandomCells random;
};

TEST_P(ManyGradients, AreThoseOfEachCellToTheBit) {
    (void)with_shape(GetParam(), [&]<const StandardShape & shape>() {
        for (std::size_t i = 0; i < cells; ++i) random.put_cell(shape.corners);
        std::vector<CellGradient> found(cells);
        many_gradients(shape.type, random.vertex, random.samples, found);
        std::size_t solved = 0;
        for (std::size_t i = 0; i < cells; ++i) {
            std::array<Sample, shape.corners> corners;
            for (std::size_t c = 0; c < shape.corners; ++c)
                corners[c] = random.samples[random.vertex[i * shape.corners + c]];
            const CellGradient expected = standard_gradient<shape>(corners);
            EXPECT_EQ(std::memcmp(&expected.gradient, &found[i].gradient, sizeof expected.gradient), 0) << i;
            EXPECT_EQ(expected.volume, found[i].volume) << i;
            solved += expected.volume > 0 ? 1 : 0;
        }
        EXPECT_GT(solved, cells / 2);
        EXPECT_LT(solved, cells);
    });
}

INSTANTIATE_TEST_SUITE_P(Types, ManyGradients,
                         testing::Values(CellType::tetrahedron, CellType::hexahedron, CellType::wedge,
                                         CellType::pyramid));

// All fields of a Mesh share its fits. A mesh that was moved must not use the fits of the first positions.
TEST(MeshFits, BelongToThePositions) {
    const Polyhedra input = voronoi(300, 3);
    std::vector<float> points = input.positions;
    const ArrayView rows(points, 3);
    const auto make = [&] {
        return Mesh::from_polyhedra(rows, input.cell_offset, input.face_offset, input.face_vertex);
    };
    const Mesh mesh = make(), unused = make();
    const std::vector<float> values = random_field(input.vertex_count(), 4);
    (void)contour(mesh, values, 0.5);
    for (std::size_t i = 0; i < points.size(); i += 3) points[i] *= 4;
    EXPECT_EQ(contour(mesh.moved(rows), values, 0.5).normals, contour(unused.moved(rows), values, 0.5).normals);
    EXPECT_GT(mesh.cell_fits()->memory_bytes(), 1000U);
}

} // namespace
} // namespace ciel::test
