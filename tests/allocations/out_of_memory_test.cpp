// Fails each allocation of the kernel in turn: the call must throw, and the next call must be correct.
#include "allocations/counted_new.hpp"
#include "blocks/blocks.hpp"
#include "ciel/extract.hpp"
#include "ciel/geometric_vertices.hpp"
#include "ciel/sweep_sinks.hpp"
#include "fields/cell_ranges.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"
#include "support/views.hpp"
#include "support/volume_property.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <thread>

namespace ciel::test {
using namespace server;
namespace {

// True for the test meshes with all kinds of cells, or with vertices that several blocks share.
bool is_chosen(const NamedMesh& mesh) {
    static const std::vector<std::string> chosen{"zoo_shuffled", "voronoi", "o_grid", "hanging_nodes"};
    return std::ranges::find(chosen, mesh.name) != chosen.end();
}

std::vector<NamedMesh> chosen_meshes() {
    std::vector<NamedMesh> out;
    std::ranges::copy_if(all_meshes(), std::back_inserter(out), is_chosen);
    return out;
}

bool same_point(const EdgePoint& a, const EdgePoint& b) { return a.a == b.a && a.b == b.b && a.t == b.t; }
bool same_chunk(const Surface::Chunk& a, const Surface::Chunk& b) {
    return a.block == b.block && a.polygon_begin == b.polygon_begin && a.polygon_end == b.polygon_end;
}
bool same(const Surface& a, const Surface& b) {
    return a.positions == b.positions && a.normals == b.normals && std::ranges::equal(a.points, b.points, same_point) &&
           a.polygon_offset == b.polygon_offset && a.polygon_vertex == b.polygon_vertex &&
           a.polygon_cell == b.polygon_cell && std::ranges::equal(a.chunks, b.chunks, same_chunk);
}

// A mesh with two sets of positions and two fields with missing values. The fields' lazy data has not been computed.
struct Data {
    explicit Data(const NamedMesh& named)
        : input(named.make()), assembled(assemble(view(input))), topology(assembled.mesh.view(), {32}),
          moved(assembled.mesh), values{random_field(topology.counts().vertices, 3),
                                        random_field(topology.counts().vertices, 4)} {
        for (std::size_t i = 0; i < moved.positions.size(); ++i) moved.positions[i] *= i % 3 == 1 ? 2.0F : 0.5F;
        values[0][values[0].size() / 2] = std::numeric_limits<float>::quiet_NaN();
    }
    [[nodiscard]] std::array<Field, 2> fields() const {
        const auto fits = std::make_shared<CellFits>(topology);
        std::array all{Field(topology, values[0], kept_by_test), Field(topology, values[1], kept_by_test)};
        for (Field& field : all) field.set_cell_fits(fits);
        return all;
    }

    Polyhedra input;
    Assembled assembled;
    Topology topology;
    FaceMesh moved;
    std::array<std::vector<float>, 2> values;
};

// One call of the sequence that the test makes.
struct Step {
    enum class What { field, mesh, extract };
    What what;
    int which = 0; // index of the field or of the set of positions
    double nu = 0;
};
const std::vector<Step> steps{
    {Step::What::field, 0},        {Step::What::extract, 0, 0.4}, {Step::What::extract, 0, 0.8},
    {Step::What::extract, 0, 0.3}, {Step::What::field, 1},        {Step::What::extract, 0, 0.6},
    {Step::What::mesh, 1},         {Step::What::extract, 0, 0.6}, {Step::What::extract, 0, 0.5},
    {Step::What::field, 0},        {Step::What::extract, 0, 0.2},
};

struct How {
    const char* name;
    Extraction extraction;
    std::optional<Normals> normals;
};

class Hand {
public:
    Hand(const Data& data, const How& how)
        : data_(data), normals_(how.normals), fields_(data.fields()),
          query_(data.topology, kept(data.assembled.mesh.view()), how.extraction) {
        if (normals_) query_.set_normals(*normals_);
    }
    void take(const Step& step) {
        if (step.what == Step::What::field) return query_.set_field(fields_[step.which]);
        if (step.what == Step::What::extract) return (void)query_.extract(step.nu, normals_.has_value(), surface);
        query_.set_mesh(kept(data_.moved.view()));
        for (Field& field : fields_) field.vertices_moved();
    }

    Surface surface;

private:
    const Data& data_;
    std::optional<Normals> normals_;
    std::array<Field, 2> fields_;
    Query query_;
};

// The expected surface of each `extract` step, from a new query.
std::vector<Surface> expected_surfaces(const Data& data, const How& how) {
    std::vector<Surface> out;
    Step field, mesh{Step::What::mesh};
    for (const Step& step : steps) {
        if (step.what == Step::What::field) field = step;
        if (step.what == Step::What::mesh) mesh = step;
        if (step.what != Step::What::extract) continue;
        Hand fresh(data, how);
        if (mesh.which == 1) fresh.take(mesh);
        fresh.take(field);
        fresh.take(step);
        out.push_back(std::move(fresh.surface));
    }
    return out;
}

class OutOfMemory : public testing::TestWithParam<std::tuple<NamedMesh, How>> {};

// Runs all steps while the nth allocation fails, and repeats the step that throws. Returns false when no step threw.
bool fails_once(Hand& hand, std::size_t nth, const std::vector<Surface>& expected) {
    bool thrown = false;
    std::size_t surfaces = 0;
    const FailingAllocation failing(nth);
    for (const Step& step : steps) {
        try {
            hand.take(step);
        } catch (const std::bad_alloc&) {
            thrown = true;
            hand.take(step);
        }
        if (step.what == Step::What::extract) {
            EXPECT_TRUE(same(hand.surface, expected[surfaces])) << "surface " << surfaces << ", allocation " << nth;
            ++surfaces;
        }
    }
    EXPECT_EQ(thrown, FailingAllocation::has_failed()) << "somebody has swallowed it";
    return thrown;
}

// Runs f on a new thread, which has no scratch memory yet.
template <class F>
void on_new_thread(F&& f) {
    std::thread(std::forward<F>(f)).join();
}

TEST_P(OutOfMemory, NextSurfaceIsRight) {
    const NamedMesh& named = std::get<0>(GetParam());
    const How& how = std::get<1>(GetParam());
    const ThreadCount one(1);
    const Data data(named);
    const std::vector<Surface> expected = expected_surfaces(data, how);
    bool failed = true;
    std::size_t nth = 0;
    while (failed && !HasFailure())
        on_new_thread([&] {
            Hand hand(data, how);
            failed = fails_once(hand, ++nth, expected);
        });
    EXPECT_GT(nth, 50U);
}

// With four threads, an allocation of one thread fails while the others work.
TEST_P(OutOfMemory, NextSurfaceIsRightWithFourThreads) {
    const NamedMesh& named = std::get<0>(GetParam());
    const How& how = std::get<1>(GetParam());
    const ThreadCount four(4);
    const Data data(named);
    const std::vector<Surface> expected = expected_surfaces(data, how);
    bool failed = true;
    for (std::size_t nth = 1; failed && !HasFailure(); nth += 3) {
        Hand hand(data, how);
        failed = fails_once(hand, nth, expected);
    }
}

const std::vector<How> ways{
    {"signatures_gradients", {}, Normals::gradient},
    {"signatures_polygons", {}, Normals::polygons},
    {"decided", {Algorithm::signatures, Decider::asymptotic}, {}},
    {"propagation", {Algorithm::propagation}, {}},
    {"propagation_gradients", {Algorithm::propagation}, Normals::gradient},
    {"naive", {Algorithm::naive}, Normals::polygons},
};

INSTANTIATE_TEST_SUITE_P(meshes, OutOfMemory,
                         testing::Combine(testing::ValuesIn(chosen_meshes()), testing::ValuesIn(ways)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

bool same(const SliceSink::Out& a, const SliceSink::Out& b) {
    return a.positions == b.positions && a.property == b.property && a.triangles == b.triangles;
}
bool same(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) { return a == b; }
bool same(const color::SlabTriangles& a, const color::SlabTriangles& b) {
    return a.triangles == b.triangles && std::ranges::equal(a.vertices, b.vertices, [](const auto& p, const auto& q) {
               return p.position == q.position && p.value == q.value && p.gradient == q.gradient &&
                      p.limits == q.limits;
           });
}

class SweepOutOfMemory : public testing::TestWithParam<std::tuple<NamedMesh, How>> {
protected:
    template <class Sink>
    void expect_right(const Sink& sink) {
        const FaceMeshView mesh = kept(data.assembled.mesh.view());
        const Extraction extraction = std::get<1>(GetParam()).extraction;
        const std::vector<double> nus{0.5, 0.2, 0.9, 0.3};
        using Outs = std::vector<typename Sink::Out>;
        std::array<Outs, 2> expected;
        const auto cut = [&](const Field& field, SweepBuffers<Sink>& scratch, Outs& out) {
            (void)sweep(data.topology, mesh, field, nus, sink, scratch, out, {}, extraction);
        };
        for (int i = 0; i < 2; ++i) {
            SweepBuffers<Sink> scratch;
            cut(data.fields()[i], scratch, expected[i]);
        }
        bool failed = true;
        const auto one_run = [&](std::size_t nth) {
            failed = false;
            const std::array<Field, 2> fields = data.fields();
            SweepBuffers<Sink> scratch;
            Outs out;
            const FailingAllocation failing(nth);
            for (const int i : {0, 0, 1, 0}) {
                try {
                    cut(fields[i], scratch, out);
                } catch (const std::bad_alloc&) {
                    failed = true;
                    cut(fields[i], scratch, out);
                }
                ASSERT_EQ(out.size(), nus.size());
                for (std::size_t k = 0; k < nus.size(); ++k)
                    EXPECT_TRUE(same(out[k], expected[i][k])) << "value " << k << ", allocation " << nth;
            }
        };
        for (std::size_t nth = 1; failed && !HasFailure(); ++nth) on_new_thread([&] { one_run(nth); });
    }

    const ThreadCount one{1};
    const Data data{std::get<0>(GetParam())};
};

TEST_P(SweepOutOfMemory, OfASoup) { expect_right(SoupSink{}); }
TEST_P(SweepOutOfMemory, OfAnOutline) { expect_right(OutlineSink{}); }
TEST_P(SweepOutOfMemory, OfASlice) { expect_right(SliceSink{data.values[1]}); }
TEST_P(SweepOutOfMemory, OfASlab) {
    const VolumeProperty property(data.topology, data.assembled.mesh.view(), data.values[1]);
    expect_right(geometry::SlabSink{property.view()});
}

const std::vector<How> sweep_ways{
    {"signatures", {}, {}},
    {"decided", {Algorithm::signatures, Decider::asymptotic}, {}},
    {"propagation", {Algorithm::propagation}, {}},
};

INSTANTIATE_TEST_SUITE_P(meshes, SweepOutOfMemory,
                         testing::Combine(testing::ValuesIn(chosen_meshes()), testing::ValuesIn(sweep_ways)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

class OnDemandOutOfMemory : public testing::TestWithParam<NamedMesh> {
protected:
    // Calls ask(1), ask(2), ... until one returns false, which means that no allocation failed.
    template <class F>
    void fail_each(F&& ask) {
        bool failed = true;
        for (std::size_t nth = 1; failed && !HasFailure(); ++nth) failed = ask(nth);
    }
    template <class F>
    [[nodiscard]] static bool fails(std::size_t nth, F&& f) {
        const FailingAllocation failing(nth);
        try {
            f();
        } catch (const std::bad_alloc&) {
            return true;
        }
        return false;
    }
    const ThreadCount one{1};
    const Data data{GetParam()};
};

// A field's minima along a direction, and the candidate vertices for them.
TEST_P(OnDemandOutOfMemory, Extrema) {
    const FaceMeshView mesh = kept(data.assembled.mesh.view());
    const std::vector<float> distance = plane_distance(mesh, mesh.origin, {0.6, 0.8, 0});
    const Field everywhere(data.topology, distance, kept_by_test);
    const std::span<const Index> expected = everywhere.sorted_minima();
    const auto where_expected = GeometricVertices(mesh).find(data.topology).vertices;
    fail_each([&](std::size_t nth) {
        const auto where = std::make_shared<const GeometricVertices>(mesh);
        Field field(data.topology, distance, kept_by_test);
        field.set_direction(where, {0.6, 0.8, 0});
        const bool failed = fails(nth, [&] { (void)field.sorted_minima(); });
        EXPECT_TRUE(std::ranges::equal(field.sorted_minima(), expected));
        EXPECT_EQ(where->find(data.topology).vertices, where_expected);
        return failed;
    });
}

// CellRanges that failed to build must be built by the next call. Without the ranges, extraction is correct but slow.
TEST_P(OnDemandOutOfMemory, RangesOfCells) {
    const detail::Block& block = data.topology.blocks().cells(0);
    const std::vector<float> values = random_field(block.vertex_count, 5);
    const auto twice = [&](detail::CellRanges& ranges) {
        ranges.resize(1);
        (void)ranges.of(block, 0, values);
        return ranges.of(block, 0, values);
    };
    detail::CellRanges fresh;
    const auto expected = twice(fresh);
    fail_each([&](std::size_t nth) {
        detail::CellRanges ranges;
        ranges.resize(1);
        (void)ranges.of(block, 0, values);
        const bool failed = fails(nth, [&] { (void)ranges.of(block, 0, values); });
        EXPECT_TRUE(std::ranges::equal(ranges.of(block, 0, values), expected));
        return failed;
    });
}

INSTANTIATE_TEST_SUITE_P(meshes, OnDemandOutOfMemory, testing::ValuesIn(chosen_meshes()),
                         [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ciel::test
