// Blocks far behind the first 2^33 half-edges. The blocks of a small mesh come after made-up blocks of billions of
// cells, which have no records. The results are those of the small mesh to the bit, with ids moved up.
#include "blocks/block_tables.hpp"
#include "ciel/cell_locator.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/copied_records.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "wire/files/export_vtp.hpp"
#include "wire/files/joined_surface.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <sstream>
#include <sys/mman.h>

namespace ciel::test {

using namespace ciel::detail;

namespace {

constexpr Index absent = 6; // number of made-up blocks
constexpr Index cells_in_each = 700'000'000, vertices_in_each = 600'000'000, edges_in_each = 710'000'000,
                half_edges_in_each = 4'000'000'000;
constexpr Index first_cell = absent * cells_in_each, first_vertex = absent * vertices_in_each,
                first_edge = absent * edges_in_each;
static_assert(std::uint64_t{absent} * half_edges_in_each > std::uint64_t{1} << 33U);
static_assert(first_cell > 1U << 31U && first_vertex > 1U << 31U && first_edge > 1U << 31U);

std::vector<Index> moved_up(const std::vector<Index>& prefix, Index by_each) {
    std::vector<Index> moved;
    for (Index b = 0; b < absent; ++b) moved.push_back(b * by_each);
    for (const Index number : prefix) moved.push_back(absent * by_each + number);
    return moved;
}

RecordBytes tables_behind(const Topology& topology) {
    BlockNumbers numbers;
    TopologyCounts counts;
    const std::vector<std::uint64_t> near = topology.tables();
    read_tables(std::as_bytes(std::span(near)), numbers, counts);
    numbers.cell = moved_up(numbers.cell, cells_in_each);
    numbers.vertex = moved_up(numbers.vertex, vertices_in_each);
    numbers.edge = moved_up(numbers.edge, edges_in_each);
    numbers.slot = moved_up(numbers.slot, vertices_in_each);
    numbers.half_edges.insert(numbers.half_edges.begin(), absent, half_edges_in_each);
    numbers.border_vertices.insert(numbers.border_vertices.begin(), absent, 0);
    counts.cells += first_cell;
    counts.vertices += first_vertex;
    counts.edges += first_edge;
    counts.half_edges += std::uint64_t{absent} * half_edges_in_each;
    return tables_of(numbers, counts);
}

class FarRecords final : public RecordSource {
public:
    explicit FarRecords(const Topology& near) : near_(near) {}

    std::span<const std::byte> record(Index block, RecordKind kind) override {
        if (block < absent) throw Error("a made-up block was read");
        return near_.record(block - absent, kind);
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

private:
    CopiedRecords near_;
};

// Positions of all vertices in a mapping that takes memory only where it is written. Those of the made-up blocks are
// zeros.
class FarPositions {
public:
    explicit FarPositions(std::span<const float> near) : count_(std::size_t{3} * first_vertex + near.size()) {
        void* const data = ::mmap(nullptr, count_ * sizeof(float), PROT_READ | PROT_WRITE,
                                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (data == MAP_FAILED) return;
        begin_ = static_cast<float*>(data);
        std::ranges::copy(near, begin_ + std::size_t{3} * first_vertex);
    }
    FarPositions(const FarPositions&) = delete;
    ~FarPositions() {
        if (begin_ != nullptr) ::munmap(begin_, count_ * sizeof(float));
    }
    [[nodiscard]] bool empty() const { return begin_ == nullptr; }
    [[nodiscard]] std::span<const float> get() const { return {begin_, count_}; }
    [[nodiscard]] std::span<const std::uint8_t> zeros() const {
        return {reinterpret_cast<const std::uint8_t*>(begin_), std::size_t{3} * first_vertex * sizeof(float)};
    }

private:
    std::size_t count_;
    float* begin_ = nullptr;
};

class FarValues final : public ValueSource {
public:
    explicit FarValues(std::vector<float> near) : near_(std::move(near)) {}

    [[nodiscard]] std::size_t size() const override { return std::size_t{first_vertex} + near_.size(); }
    [[nodiscard]] bool has_doubles() const override { return false; }
    void read(Index first, std::span<float> out) const override {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = near_.at(first - first_vertex + i);
    }
    void read(std::span<const Index> vertices, std::span<float> out) const override {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = near_.at(vertices[i] - first_vertex);
    }
    void read(Index, std::span<double>) const override { FAIL(); }
    void read(std::span<const Index>, std::span<double>) const override { FAIL(); }

private:
    std::vector<float> near_;
};

// Inserts the ranges of the made-up blocks, each from `low` to `high`, before those of the small mesh.
BlockRanges behind(BlockRanges near, double low, double high) {
    near.low.insert(near.low.begin(), absent, low);
    near.high.insert(near.high.begin(), absent, high);
    near.missing.insert(near.missing.begin(), absent, 0);
    return near;
}

BlockRanges without_values(BlockRanges near) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return behind(std::move(near), infinity, -infinity);
}

// Returns the content of a VTP file. Points at one mesh vertex are merged by its id.
std::string exported(const Surface& surface) {
    server::wire::JoinedSurface joined;
    joined.add(surface, {});
    std::ostringstream out;
    (void)server::wire::write_vtp({joined.surface(), {}, joined.values()}, out);
    return out.str();
}

class FarBlocks : public testing::TestWithParam<NamedMesh> {
protected:
    void SetUp() override {
        if (far_positions.empty()) GTEST_SKIP() << "this machine reserves no " << (first_vertex >> 28U) * 3 << " GiB";
        points.positions = far_positions.get();
        points.cell_types = far_positions.zeros().first(far.counts().cells);
    }

    // Raises the ids of a surface of the small mesh by the cells, vertices and blocks of the made-up blocks.
    static Surface behind_others(Surface surface) {
        for (Index& cell : surface.polygon_cell) cell += first_cell;
        for (EdgePoint& point : surface.points) {
            point.a += first_vertex;
            point.b += first_vertex;
        }
        for (Surface::Chunk& chunk : surface.chunks) chunk.block += absent;
        return surface;
    }

    [[nodiscard]] std::vector<Index> far_blocks() const {
        std::vector<Index> blocks(near.topology.block_count());
        std::iota(blocks.begin(), blocks.end(), absent);
        return blocks;
    }

    const Polyhedra input = GetParam().make();
    const KernelMesh near{input, {16}};
    const RecordBytes tables = tables_behind(near.topology);
    const Topology far{std::as_bytes(std::span(tables)), std::make_unique<FarRecords>(near.topology)};
    const FarPositions far_positions{near.mesh().positions.floats()};
    FaceMeshView points = near.mesh();
};

TEST_P(FarBlocks, HaveTheSameSurfaces) {
    const std::vector<float> values = near.stored(random_field(input.vertex_count(), 31));
    const Field of_near = make_field(near.topology, values);
    const Field of_far(far, std::make_shared<FarValues>(values), without_values(block_ranges(near.topology, values)));
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::naive})
        for (const Normals normals : {Normals::gradient, Normals::polygons}) {
            Query expected = near.query(algorithm), found(far, points, algorithm);
            expected.set_field(of_near);
            found.set_field(of_far);
            expected.set_normals(normals);
            found.set_normals(normals);
            if (algorithm == Algorithm::naive) found.set_blocks(far_blocks()); // otherwise it reads made-up blocks
            for (const double nu : walk_through(values, 4, 32)) {
                Surface a, b;
                ASSERT_TRUE(expected.extract(nu, true, a));
                ASSERT_TRUE(found.extract(nu, true, b));
                ASSERT_EQ(bit_difference(behind_others(a), b), "") << nu;
                ASSERT_EQ(exported(a), exported(b)) << nu;
            }
        }
}

// The made-up blocks lie in the middle of the mesh, where no slice is made.
TEST_P(FarBlocks, HaveTheSameSlices) {
    const BlockBoxes boxes = block_boxes(near.topology, near.mesh().positions);
    Vec3d middle{};
    BlockBoxes far_boxes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = (std::ranges::min(boxes[axis].low) + std::ranges::max(boxes[axis].high)) / 2;
        far_boxes[axis] = behind(boxes[axis], middle[axis], middle[axis]);
        middle[axis] += near.mesh().origin[axis];
    }
    const Vec3d normal{0.3, -0.5, 0.8};
    const Field of_near = Field::plane(near.topology, near.mesh(), middle, normal, boxes);
    const Field of_far = Field::plane(far, points, middle, normal, far_boxes);
    EXPECT_EQ(of_near.range(), of_far.range());
    Query expected = near.query(), found(far, points);
    expected.set_field(of_near);
    found.set_field(of_far);
    for (const double nu : {-0.4, -0.1, 0.1, 0.2, 0.5}) {
        Surface a, b;
        ASSERT_TRUE(expected.extract(nu, false, a));
        ASSERT_TRUE(found.extract(nu, false, b));
        ASSERT_FALSE(a.polygon_cell.empty());
        ASSERT_EQ(bit_difference(behind_others(a), b), "") << nu;
    }
}

TEST_P(FarBlocks, AreProbedAlike) {
    const auto boxes = std::make_shared<const BlockBoxes>(block_boxes(near.topology, near.mesh().positions));
    auto far_boxes = std::make_shared<BlockBoxes>(*boxes);
    for (BlockRanges& axis : *far_boxes) axis = without_values(std::move(axis));
    const CellLocator expected(near.topology, near.mesh(), boxes), found(far, points, far_boxes);
    std::mt19937 random(33);
    int inside = 0;
    for (int i = 0; i < 30; ++i) {
        Vec3d place = near.mesh().origin;
        for (int k = 0; k < 4; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] += near.mesh().positions[3 * (random() % near.mesh().vertex_count()) + axis] / 4;
        const Index cell = expected.cell_at(place);
        ASSERT_EQ(found.cell_at(place), cell == none ? none : cell + first_cell);
        if (cell == none) continue;
        ++inside;
        VertexWeights weights = expected.weights_in(cell, place);
        for (auto& [vertex, share] : weights) vertex += first_vertex;
        EXPECT_EQ(found.weights_in(cell + first_cell, place), weights);
        EXPECT_EQ(found.nearest_vertex(cell + first_cell, place), expected.nearest_vertex(cell, place) + first_vertex);
    }
    EXPECT_GT(inside, 0);
}

TEST_P(FarBlocks, HaveTheSameOperators) {
    const auto moved = [](HalfEdge h) {
        return h == no_half_edge ? h : HalfEdge{static_cast<std::uint64_t>(h) + (std::uint64_t{absent} << 32U)};
    };
    const auto id = [](Index near_id, Index first) { return near_id == none ? none : near_id + first; };
    for (Index cell = 0; cell < near.topology.counts().cells; ++cell) {
        EXPECT_EQ(far.half_edge_begin(first_cell + cell), moved(near.topology.half_edge_begin(cell)));
        for (const HalfEdge h : near.topology.half_edges(cell)) {
            const HalfEdge there = moved(h);
            ASSERT_EQ(far.vertex(there), near.topology.vertex(h) + first_vertex);
            ASSERT_EQ(far.edge(there), id(near.topology.edge(h), first_edge));
            ASSERT_EQ(far.cell(there), cell + first_cell);
            ASSERT_EQ(far.next_around_face(there), moved(near.topology.next_around_face(h)));
            ASSERT_EQ(far.next_around_vertex(there), moved(near.topology.next_around_vertex(h)));
            ASSERT_EQ(far.mate_face(there), moved(near.topology.mate_face(h)));
            ASSERT_EQ(far.mate_polyhedron(there), moved(near.topology.mate_polyhedron(h)));
        }
    }
    for (Index v = 0; v < near.topology.counts().vertices; ++v)
        ASSERT_EQ(far.half_edge_of_vertex(first_vertex + v), moved(near.topology.half_edge_of_vertex(v)));
}

std::vector<NamedMesh> some_meshes() {
    std::vector<NamedMesh> some;
    for (const NamedMesh& mesh : all_meshes())
        if (mesh.make().cell_count() > 50) some.push_back(mesh);
    return some;
}

INSTANTIATE_TEST_SUITE_P(Meshes, FarBlocks, testing::ValuesIn(some_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
