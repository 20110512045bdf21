// Values and positions that are read when a block needs them, as from a file: the surfaces and gradients are those of
// values and positions in memory, and what no block needs is not read.
#include "ciel/sweep_sinks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <mutex>
#include <utility>

namespace ciel::test {
namespace {

// Counts the values that are read.
template <class Value>
class CountedValues final : public ValueSource {
public:
    explicit CountedValues(std::vector<Value> values) : values_(std::move(values)) {}

    [[nodiscard]] std::size_t size() const override { return values_.size(); }
    [[nodiscard]] bool has_doubles() const override { return std::same_as<Value, double>; }
    void read(Index first, std::span<float> out) const override { copy(first, out); }
    void read(Index first, std::span<double> out) const override { copy(first, out); }
    void read(std::span<const Index> vertices, std::span<float> out) const override { gather(vertices, out); }
    void read(std::span<const Index> vertices, std::span<double> out) const override { gather(vertices, out); }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    template <class T>
    void copy(Index first, std::span<T> out) const {
        ASSERT_TRUE((std::same_as<T, Value>));
        count_ += out.size();
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<T>(values_.at(first + i));
    }
    template <class T>
    void gather(std::span<const Index> vertices, std::span<T> out) const {
        ASSERT_TRUE((std::same_as<T, Value>));
        count_ += out.size();
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<T>(values_.at(vertices[i]));
    }

    std::vector<Value> values_;
    mutable std::atomic<std::size_t> count_ = 0;
};

// Positions are NaN until they are loaded.
template <class Number>
class HiddenPositions final : public VertexLoader {
public:
    HiddenPositions(const KernelMesh& mesh)
        : VertexLoader(mesh.topology.block_count()), true_(mesh.mesh().positions.begin(), mesh.mesh().positions.end()),
          shown_(true_.size(), std::numeric_limits<Number>::quiet_NaN()), has_vertex_(true_.size() / 3) {}

    void load(Index begin, Index end) const override {
        const std::lock_guard lock(mutex_); // each position is written once: other threads may be reading it
        for (std::size_t v = begin; v < end; ++v) {
            if (std::exchange(has_vertex_.at(v), 1) != 0) continue;
            std::copy_n(true_.begin() + static_cast<std::ptrdiff_t>(3 * v), 3,
                        shown_.begin() + static_cast<std::ptrdiff_t>(3 * v));
        }
    }
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(std::ranges::count(has_vertex_, 1)); }
    [[nodiscard]] FaceMeshView hidden(const KernelMesh& mesh) const { return with(mesh, shown_, this); }
    [[nodiscard]] FaceMeshView known(const KernelMesh& mesh) const { return with(mesh, true_, nullptr); }

private:
    static FaceMeshView with(const KernelMesh& mesh, const std::vector<Number>& positions, const VertexLoader* loader) {
        FaceMeshView view = mesh.mesh();
        view.positions = positions;
        view.loader = loader;
        return view;
    }

    std::vector<Number> true_;
    mutable std::mutex mutex_;
    mutable std::vector<Number> shown_;
    mutable std::vector<std::uint8_t> has_vertex_;
};

template <class Number>
void compare_surfaces(const KernelMesh& mesh, const std::vector<float>& values, Algorithm algorithm) {
    const std::vector<Number> stored(values.begin(), values.end());
    const Field known(mesh.topology, stored, kept_by_test);
    const Field read(mesh.topology, std::make_shared<CountedValues<Number>>(stored),
                     block_ranges(mesh.topology, stored));
    EXPECT_EQ(read.range(), known.range());
    for (const Normals normals : {Normals::gradient, Normals::polygons}) {
        const HiddenPositions<Number> positions(mesh); // no position is loaded yet
        Query from_memory(mesh.topology, positions.known(mesh), algorithm);
        Query from_file(mesh.topology, positions.hidden(mesh), algorithm);
        from_memory.set_field(known);
        from_file.set_field(read);
        from_memory.set_normals(normals);
        from_file.set_normals(normals);
        for (const double nu : walk_through(values, 4, 501)) {
            Surface expected, found;
            ASSERT_TRUE(from_memory.extract(nu, true, expected));
            ASSERT_TRUE(from_file.extract(nu, true, found));
            ASSERT_EQ(bit_difference(expected, found), "") << nu;
        }
    }
}

// Only odd blocks are extracted. Points on edges that belong to left-out blocks take another code path (AdoptedEdges).
template <class Number>
void compare_some_blocks(const KernelMesh& mesh, const std::vector<float>& values) {
    const std::vector<Number> stored(values.begin(), values.end());
    const Field field(mesh.topology, stored, kept_by_test);
    std::vector<Index> odd;
    for (Index b = 1; b < mesh.topology.block_count(); b += 2) odd.push_back(b);
    for (const double nu : walk_through(values, 3, 503)) {
        const HiddenPositions<Number> positions(mesh);
        Query from_memory(mesh.topology, positions.known(mesh)), from_file(mesh.topology, positions.hidden(mesh));
        Surface expected, found;
        for (auto [query, out] : {std::pair{&from_memory, &expected}, std::pair{&from_file, &found}}) {
            query->set_field(field);
            query->set_blocks(odd);
            ASSERT_TRUE(query->extract(nu, false, *out));
        }
        ASSERT_EQ(bit_difference(expected, found), "") << nu;
    }
}

template <class Number>
void compare_sweeps(const KernelMesh& mesh, const std::vector<float>& values) {
    const std::vector<Number> stored(values.begin(), values.end());
    const Field field(mesh.topology, stored, kept_by_test);
    const HiddenPositions<Number> positions(mesh);
    const std::vector<double> places = walk_through(values, 4, 504);
    std::vector<SoupSink::Out> expected, found;
    ASSERT_TRUE(sweep(mesh.topology, positions.known(mesh), field, places, SoupSink{}, expected));
    ASSERT_TRUE(sweep(mesh.topology, positions.hidden(mesh), field, places, SoupSink{}, found));
    EXPECT_EQ(found, expected);
}

template <class Number>
void compare_slices(const KernelMesh& mesh, Algorithm algorithm) {
    const HiddenPositions<Number> positions(mesh);
    const FaceMeshView known_points = positions.known(mesh), hidden_points = positions.hidden(mesh);
    const BlockBoxes boxes = block_boxes(mesh.topology, known_points.positions);
    const Vec3d origin{0.4, 0.3, 0.5}, normal{0.48, 0.6, 0.64};
    const Field known = Field::plane(mesh.topology, known_points, origin, normal, boxes);
    const Field hidden = Field::plane(mesh.topology, hidden_points, origin, normal, boxes);
    EXPECT_EQ(hidden.range(), known.range());
    const std::vector<double> places{0, 0.1, 0.25};
    std::vector<SoupSink::Out> expected, found;
    ASSERT_TRUE(sweep(mesh.topology, known_points, known, places, SoupSink{}, expected, {}, {algorithm}));
    ASSERT_TRUE(sweep(mesh.topology, hidden_points, hidden, places, SoupSink{}, found, {}, {algorithm}));
    EXPECT_EQ(found, expected);
    for (Index v = 0; v < mesh.topology.counts().vertices; ++v) ASSERT_EQ(hidden.value(v), known.value(v));
}

class LoadedVertices : public testing::TestWithParam<NamedMesh> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {4}};
};

TEST_P(LoadedVertices, GiveTheSameSurfaces) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = mesh.stored(named.make(input));
        for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::naive, Algorithm::propagation}) {
            compare_surfaces<float>(mesh, values, algorithm);
            compare_surfaces<double>(mesh, values, algorithm);
        }
    }
}

TEST_P(LoadedVertices, GiveTheSameSurfacesOfSomeBlocksAndInASweep) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = mesh.stored(named.make(input));
        compare_some_blocks<float>(mesh, values);
        compare_some_blocks<double>(mesh, values);
        compare_sweeps<float>(mesh, values);
        compare_sweeps<double>(mesh, values);
    }
}

TEST_P(LoadedVertices, GiveTheSameMinima) {
    const std::vector<float> values = mesh.stored(bumps_field(input, 505));
    const Field known(mesh.topology, values, kept_by_test);
    const Field read(mesh.topology, std::make_shared<CountedValues<float>>(values),
                     block_ranges(mesh.topology, values));
    EXPECT_THAT(read.sorted_minima(), testing::ElementsAreArray(known.sorted_minima()));
}

TEST_P(LoadedVertices, GiveTheSameSlices) {
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::naive, Algorithm::propagation}) {
        compare_slices<float>(mesh, algorithm);
        compare_slices<double>(mesh, algorithm);
    }
}

TEST_P(LoadedVertices, GiveTheSameGradients) {
    const HiddenPositions<float> positions(mesh);
    const std::vector<float> values = mesh.stored(bumps_field(input, 502));
    EXPECT_EQ(vertex_gradients(mesh.topology, positions.hidden(mesh), values),
              vertex_gradients(mesh.topology, positions.known(mesh), values));
}

INSTANTIATE_TEST_SUITE_P(All, LoadedVertices, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

// A value that no block has reads nothing. A surface in one corner of the mesh reads few vertices.
TEST(LoadedVerticesOfBlocks, AreThoseThatTheSurfaceCrosses) {
    const Polyhedra input = tetrahedra({{12, 12, 12}});
    const KernelMesh mesh(input, {32});
    const std::vector<float> values = mesh.stored(linear_field(input, {{1, 1, 1}, 0}));
    const auto source = std::make_shared<CountedValues<float>>(values);
    const Field field(mesh.topology, source, block_ranges(mesh.topology, values));
    const HiddenPositions<float> positions(mesh);
    Query query(mesh.topology, positions.hidden(mesh));
    query.set_field(field);
    query.set_normals(Normals::polygons);
    Surface surface;
    const auto [low, high] = field.range();
    ASSERT_TRUE(query.extract(high + 1, true, surface));
    EXPECT_EQ(source->count(), 0U);
    EXPECT_EQ(positions.count(), 0U);
    ASSERT_TRUE(query.extract(low + 0.1 * (high - low), true, surface));
    ASSERT_FALSE(surface.polygon_cell.empty());
    EXPECT_GT(positions.count(), 0U);
    EXPECT_LT(positions.count(), values.size() / 10);
    EXPECT_LT(source->count(), values.size() / 5) << "vertices that blocks share are read for each of them";
    EXPECT_TRUE(field.values().empty());
}

class FailingValues final : public ValueSource {
public:
    [[nodiscard]] std::size_t size() const override { return 27; }
    [[nodiscard]] bool has_doubles() const override { return false; }
    void read(Index, std::span<float> out) const override { fill(out); }
    void read(Index, std::span<double>) const override {}
    void read(std::span<const Index>, std::span<float> out) const override { fill(out); }
    void read(std::span<const Index>, std::span<double>) const override {}
    std::atomic<bool> fails = true;

private:
    void fill(std::span<float> out) const {
        if (fails) throw Error("the disk is gone");
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<float>(i);
    }
};

TEST(LoadedVerticesOfBlocks, AreReadAgainAfterAFailure) {
    const KernelMesh mesh(hexahedra({{2, 2, 2}}));
    const auto source = std::make_shared<FailingValues>();
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        Query query = mesh.query(algorithm);
        Surface surface;
        source->fails = true;
        const Field fresh(mesh.topology, source, {{0}, {26}, {0}});
        const auto attempt = [&] {
            query.set_field(fresh);
            return query.extract(13, false, surface);
        };
        EXPECT_THROW((void)attempt(), Error);
        source->fails = false;
        EXPECT_TRUE(attempt());
        EXPECT_FALSE(surface.polygon_cell.empty());
    }
}

TEST(LoadedVerticesOfBlocks, MustBeAsManyAsTheMeshHas) {
    const KernelMesh mesh(hexahedra({{2, 2, 1}}));
    EXPECT_THROW(Field(mesh.topology, std::make_shared<FailingValues>(), {{0}, {26}, {0}}), Error);
}

} // namespace
} // namespace ciel::test
