// Another process rewrites records after their check. Every use of the topology must end, stay in bounds, and give
// indices in range or an Error. Sanitizers detect accesses out of bounds; an alarm stops a run that does not end.
#include "ciel/geometric_vertices.hpp"
#include "ciel/sweep_sinks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/copied_records.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/mapped_records.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"

#include <atomic>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <thread>
#include <unistd.h>

namespace ciel::test {
namespace {

constexpr int changes_per_mesh = 6;   // raise it to search for more
constexpr unsigned longest_run = 300; // seconds

// Races are part of this test: a second thread changes what others read, and wrong local ids make threads read and
// write the same values. Where a sanitizer would report them, there is only one thread.
#if defined(__SANITIZE_THREAD__)
constexpr bool may_race = false;
#else
constexpr bool may_race = true;
#endif

// Changes a few words, or a range of them, while others may read them.
void change(std::span<std::uint16_t> words, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    const auto set = [&](std::size_t at, std::uint16_t to) {
        std::atomic_ref(words[at]).store(to, std::memory_order_relaxed);
    };
    const auto any = [&] { return static_cast<std::uint16_t>(below(65536)); };
    const std::size_t begin = below(words.size()), most = words.size() - begin;
    const std::size_t count = std::min(most, std::size_t{1} << below(below(4) == 0 ? 16 : 6));
    switch (below(8)) {
    case 0: // zeros, like a page beyond the end of a truncated file
        for (std::size_t i = begin; i < begin + count; ++i) set(i, 0);
        break;
    case 1:
        for (std::size_t i = begin; i < begin + count; ++i) set(i, 0xffff);
        break;
    case 2:
        for (std::size_t i = begin; i < begin + count; ++i) set(i, any());
        break;
    case 3:
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t a = below(words.size()), b = below(words.size());
            const std::uint16_t kept = words[a];
            set(a, words[b]);
            set(b, kept);
        }
        break;
    case 4: // small numbers, which are more often valid ids
        for (std::size_t i = 0; i < count; ++i) set(below(words.size()), static_cast<std::uint16_t>(below(64)));
        break;
    case 5:
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = below(words.size());
            set(at, static_cast<std::uint16_t>(words[at] + 1 - 2 * below(2)));
        }
        break;
    default:
        for (std::size_t i = 0; i < count; ++i)
            set(below(words.size()), below(4) == 0 ? std::uint16_t{0xffff} : below(3) == 0 ? std::uint16_t{0} : any());
    }
}

// Calls every function of a topology. The message of an Error must say what to do (says_what_to_do).
class EveryUse {
public:
    EveryUse(const Topology& topology, const FaceMeshView& mesh, std::span<const float> values)
        : topology_(topology), mesh_(mesh), values_(values) {}

    void run() {
        attempt([this] { operators(); });
        attempt([this] { keep_kept(); });
        attempt([this] {
            Field fresh(topology_, values_, kept_by_test);
            use(fresh, nullptr);
        });
        if (kept_) use(*kept_, &queries_);
        attempt([this] { vertices(); });
        attempt([this] { probe_some(topology_, mesh_); });
        attempt([this] { threshold_some(topology_, mesh_, values_); });
        attempt([this] { EXPECT_EQ(vertex_gradients(topology_, mesh_, values_).size(), topology_.counts().vertices); });
    }

private:
    using Queries = std::map<std::pair<Algorithm, Decider>, Query>;
    static constexpr std::array algorithms{Algorithm::naive, Algorithm::signatures, Algorithm::propagation};
    static constexpr std::array deciders{Decider::isolate_high, Decider::asymptotic};
    static constexpr std::array<double, 3> levels{0.3, 0.6, 0.45};

    static void attempt(const std::function<void()>& body) {
        try {
            body();
        } catch (const Error& error) {
            EXPECT_TRUE(says_what_to_do(error.what())) << error.what();
        }
    }
    void keep_kept() {
        if (!kept_) {
            kept_.emplace(topology_, values_, kept_by_test);
            kept_->set_cell_fits(std::make_shared<CellFits>(topology_));
        }
    }
    void operators();
    void walk(HalfEdge start);
    void use(Field& field, Queries* kept);
    void cut(Query& query);
    void sweeps(const Field& field);
    void vertices();
    void check(const Surface& surface) const;
    void check(const BlockPolygons& cut) const;

    const Topology& topology_;
    FaceMeshView mesh_;
    std::span<const float> values_;
    std::optional<Field> kept_;
    Queries queries_;
    std::vector<HalfEdge> half_edges_; // of the first run, so some may not exist any more
};

void EveryUse::operators() {
    const TopologyCounts& counts = topology_.counts();
    if (half_edges_.empty())
        for (Index cell = 0; cell < counts.cells; ++cell)
            for (const HalfEdge h : topology_.half_edges(cell)) half_edges_.push_back(h);
    for (Index cell = 0; cell < counts.cells; ++cell) attempt([&] { (void)topology_.half_edges(cell); });
    for (Index vertex = 0; vertex < counts.vertices; ++vertex)
        attempt([&] { (void)topology_.half_edge_of_vertex(vertex); });
    for (const HalfEdge h : half_edges_) {
        attempt([&] { EXPECT_LT(topology_.vertex(h), counts.vertices); });
        attempt([&] { EXPECT_LT(topology_.edge(h), counts.edges); });
        attempt([&] { EXPECT_LT(topology_.cell(h), counts.cells); });
        for (const auto next : {&Topology::next_around_face, &Topology::mate_face, &Topology::mate_polyhedron,
                                &Topology::next_around_vertex})
            attempt([&] { walk((topology_.*next)(h)); });
    }
}

// Uses a half-edge that an operator returned.
void EveryUse::walk(HalfEdge h) {
    if (h == no_half_edge) return;
    EXPECT_LT(topology_.vertex(h), topology_.counts().vertices);
    EXPECT_LT(topology_.cell(h), topology_.counts().cells);
    (void)topology_.next_around_face(topology_.mate_face(h));
}

void EveryUse::use(Field& field, Queries* kept) {
    attempt([&] {
        for (const Index v : field.sorted_minima()) EXPECT_LT(v, values_.size());
    });
    for (const Algorithm algorithm : algorithms)
        for (const Decider decider : deciders) {
            Query fresh(topology_, mesh_, {algorithm, decider});
            fresh.set_field(field);
            cut(fresh);
            if (kept == nullptr) continue;
            const auto [found, is_new] =
                kept->try_emplace({algorithm, decider}, topology_, mesh_, Extraction{algorithm, decider});
            if (is_new) found->second.set_field(field);
            cut(found->second);
        }
    sweeps(field);
    attempt([&] { field.take_in(); });
    field.vertices_moved();
}

void EveryUse::cut(Query& query) {
    std::vector<Index> some;
    for (Index b = 1; b < topology_.block_count(); b += 2) some.push_back(b);
    Surface surface;
    for (const bool all : {false, true})
        for (const Normals normals : {Normals::gradient, Normals::polygons})
            for (const double nu : levels)
                attempt([&] {
                    query.set_blocks(all ? std::nullopt : std::optional<std::span<const Index>>(some));
                    query.set_normals(normals);
                    query.extract(nu, true, surface);
                    check(surface);
                });
}

void EveryUse::sweeps(const Field& field) {
    for (const Algorithm algorithm : algorithms)
        for (const Decider decider : deciders)
            attempt([&] {
                SweepScratch scratch;
                sweep(topology_, mesh_, field, levels,
                      [this](std::size_t, Index, const BlockPolygons& cut) { check(cut); }, scratch, {},
                      {algorithm, decider});
            });
    attempt([&] {
        std::vector<OutlineSink::Out> outlines;
        sweep(topology_, mesh_, field, levels, OutlineSink{}, outlines);
    });
}

void EveryUse::vertices() {
    const auto where = std::make_shared<GeometricVertices>(mesh_);
    for (const Index v : where->find(topology_).vertices) EXPECT_LT(v, values_.size());
    const std::vector<float> distances = plane_distance(mesh_, {0.4, 0.4, 0.4}, {0.48, 0.6, 0.64});
    Field plane(topology_, distances, kept_by_test);
    plane.set_direction(where, {0.48, 0.6, 0.64});
    for (const Index v : plane.sorted_minima()) EXPECT_LT(v, values_.size());
}

void EveryUse::check(const Surface& surface) const {
    const std::size_t points = surface.points.size(), polygons = surface.polygon_cell.size();
    ASSERT_EQ(surface.positions.size(), points);
    ASSERT_EQ(surface.normals.size(), points);
    ASSERT_EQ(surface.polygon_offset.size(), polygons + 1);
    ASSERT_EQ(surface.polygon_offset.front(), 0U);
    ASSERT_EQ(surface.polygon_offset.back(), surface.polygon_vertex.size());
    for (std::size_t i = 0; i < polygons; ++i) ASSERT_LE(surface.polygon_offset[i] + 3, surface.polygon_offset[i + 1]);
    for (const EdgePoint& point : surface.points) {
        ASSERT_LT(std::max(point.a, point.b), values_.size());
        ASSERT_TRUE(point.t >= 0 && point.t <= 1);
    }
    for (const Index p : surface.polygon_vertex) ASSERT_LT(p, points);
    for (const Index cell : surface.polygon_cell) ASSERT_LT(cell, topology_.counts().cells);
    Index polygon = 0;
    for (const Surface::Chunk& chunk : surface.chunks) {
        ASSERT_LT(chunk.block, topology_.block_count());
        ASSERT_EQ(chunk.polygon_begin, polygon);
        polygon = chunk.polygon_end;
    }
    ASSERT_EQ(polygon, polygons);
}

void EveryUse::check(const BlockPolygons& cut) const {
    const std::size_t points = cut.points.size();
    ASSERT_EQ(cut.positions.size(), points);
    ASSERT_EQ(cut.polygon_cell.size(), cut.polygon_count());
    Index begin = 0;
    for (const Index end : cut.polygon_end) {
        ASSERT_LE(begin + 3, end);
        begin = end;
    }
    ASSERT_EQ(begin, cut.polygon_point.size());
    for (const EdgePoint& point : cut.points) ASSERT_LT(std::max(point.a, point.b), values_.size());
    for (const Index p : cut.polygon_point) ASSERT_LT(p, points);
    for (const Index cell : cut.polygon_cell) ASSERT_LT(cut.cell_begin + cell, topology_.counts().cells);
}

// Starts a thread that changes words until the object is destroyed.
class Changing {
public:
    Changing(std::span<std::uint16_t> words, unsigned seed)
        : thread_([this, words, seed] {
              std::mt19937 random(seed);
              while (!done_) change(words, random);
          }) {}
    Changing(const Changing&) = delete;
    Changing& operator=(const Changing&) = delete;
    ~Changing() {
        done_ = true;
        thread_.join();
    }

private:
    std::atomic<bool> done_ = false;
    std::thread thread_;
};

class ChangingTest : public testing::Test {
protected:
    void SetUp() override { alarm(longest_run); }
    void TearDown() override { alarm(0); }

    // `race`: the records change while they are used; for even seeds from the first use on.
    static void run(const KernelMesh& mesh, unsigned seed, bool race) {
        std::mt19937 random(seed);
        auto source = std::make_unique<MappedRecords>(mesh.topology);
        const std::span<std::uint16_t> words = source->words();
        const std::vector<std::uint16_t> intact(words.begin(), words.end());
        const CopiedRecords::Bytes tables = mesh.topology.tables();
        const Topology topology(std::as_bytes(std::span(tables)), std::move(source));
        std::vector<float> values = random_field(mesh.topology.counts().vertices, seed);
        if (seed % 3 == 0)
            for (std::size_t i = 7; i < values.size(); i += 31) values[i] = std::numeric_limits<float>::quiet_NaN();
        EveryUse every(topology, mesh.mesh(), values);
        std::optional<Changing> changing;
        if (race && seed % 2 == 0) changing.emplace(words, seed);
        every.run();
        changing.reset();
        std::ranges::copy(intact, words.begin());
        if (race)
            changing.emplace(words, seed);
        else
            for (std::size_t i = 0, n = 1 + seed % 7; i < n; ++i) change(words, random);
        every.run();
    }
    static void run_all(const Polyhedra& input, Topology::Options options, int changes) {
        const KernelMesh mesh(input, options);
        if (mesh.topology.counts().cells == 0) return;
        const ThreadCount threads(may_race ? 0 : 1);
        for (int seed = 1; seed <= changes; ++seed) {
            SCOPED_TRACE(seed);
            run(mesh, static_cast<unsigned>(seed), false);
            if (may_race && seed % 3 == 0) run(mesh, static_cast<unsigned>(seed), true);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
};

class ChangedRecords : public ChangingTest, public testing::WithParamInterface<NamedMesh> {};
using ChangedRecordsOfGiantCell = ChangingTest;

TEST_P(ChangedRecords, OfSmallBlocksAreHarmless) { run_all(GetParam().make(), {32}, changes_per_mesh); }

TEST_P(ChangedRecords, OfLargeBlocksAreHarmless) { run_all(GetParam().make(), {}, changes_per_mesh); }

// The giant cell has local ids of 32 bits. The topology copies their record when it checks it, so that later changes
// cannot reach them.
TEST_F(ChangedRecordsOfGiantCell, AreHarmless) { run_all(giant_cell(54), {}, 1); }

INSTANTIATE_TEST_SUITE_P(Meshes, ChangedRecords, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
