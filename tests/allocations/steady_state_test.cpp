// Repeats a sequence of values: once every buffer has reached its final size, the kernel allocates no memory.
#include "allocations/counted_new.hpp"
#include "ciel/extract.hpp"
#include "ciel/process_threads.hpp"
#include "ciel/sweep_sinks.hpp"
#include "support/fields.hpp"
#include "support/kept.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"
#include "support/volume_property.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
using namespace server;
namespace {

struct How {
    const char* name;
    Extraction extraction;
    std::optional<Normals> normals;
};

const std::vector<How> ways{
    {"signatures", {}, {}},
    {"signatures_gradients", {}, Normals::gradient},
    {"signatures_polygons", {}, Normals::polygons},
    {"decided", {Algorithm::signatures, Decider::asymptotic}, Normals::gradient},
    {"propagation", {Algorithm::propagation}, {}},
    {"propagation_gradients", {Algorithm::propagation}, Normals::gradient},
};

class SteadyState : public testing::TestWithParam<std::tuple<NamedMesh, How>> {
protected:
    void SetUp() override { set_thread_count(1); } // each thread has its own scratch memory
    void TearDown() override { set_thread_count(0); }
};

TEST_P(SteadyState, AllocatesNothing) {
    const auto& [named, how] = GetParam();
    const Polyhedra input = named.make();
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = kept(assembled.mesh.view());
    const Topology topology(mesh, {64});
    std::vector<float> values = random_field(topology.counts().vertices, 3);
    if (!values.empty()) values[values.size() / 2] = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> ones = values;
    const Field first(topology, ones, kept_by_test);
    for (float& value : values) value = 1 - value;
    const std::vector<float> others = values;
    const Field second(topology, others, kept_by_test);
    Query query(topology, mesh, how.extraction);
    if (how.normals) query.set_normals(*how.normals);
    Surface surface;
    const auto to_and_fro = [&] {
        for (const Field* field : {&first, &second}) {
            query.set_field(*field);
            for (int i = 0; i <= 40; ++i)
                (void)query.extract(i <= 20 ? i / 20.0 : 2 - i / 20.0, how.normals.has_value(), surface);
        }
    };
    to_and_fro();
    to_and_fro();
    const std::size_t before = allocations();
    to_and_fro();
    EXPECT_EQ(allocations() - before, 0U);
}

INSTANTIATE_TEST_SUITE_P(meshes, SteadyState,
                         testing::Combine(testing::ValuesIn(all_meshes()), testing::ValuesIn(ways)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

struct SweepWay {
    const char* name;
    Extraction extraction;
};

const std::vector<SweepWay> sweep_ways{
    {"signatures", {}},
    {"decided", {Algorithm::signatures, Decider::asymptotic}},
    {"propagation", {Algorithm::propagation}},
    {"naive", {Algorithm::naive}},
};

class SteadySweep : public testing::TestWithParam<std::tuple<NamedMesh, SweepWay>> {
protected:
    void SetUp() override { set_thread_count(1); }
    void TearDown() override { set_thread_count(0); }

    const Polyhedra input = std::get<0>(GetParam()).make();
    const Assembled assembled = assemble(view(input));
    const FaceMeshView mesh = kept(assembled.mesh.view());
    const Topology topology{mesh, {64}};
    const std::vector<float> values = random_field(topology.counts().vertices, 3);
    const std::vector<float> others = random_field(topology.counts().vertices, 4);

    template <class Sink>
    void expect_none(const Sink& sink) {
        const Field first(topology, values, kept_by_test), second(topology, others, kept_by_test);
        const std::vector<double> nus{0.5, 0.2, 0.9, 0.3};
        SweepBuffers<Sink> scratch;
        std::vector<typename Sink::Out> out;
        const auto both = [&] {
            for (const Field* field : {&first, &second})
                (void)sweep(topology, mesh, *field, nus, sink, scratch, out, {}, std::get<1>(GetParam()).extraction);
        };
        both();
        both();
        const std::size_t before = allocations();
        both();
        EXPECT_EQ(allocations() - before, 0U);
    }
};

TEST_P(SteadySweep, OfASoup) { expect_none(SoupSink{}); }
TEST_P(SteadySweep, OfAnOutline) { expect_none(OutlineSink{}); }
TEST_P(SteadySweep, OfASlice) { expect_none(SliceSink{others}); }
TEST_P(SteadySweep, OfASlab) {
    const VolumeProperty property(topology, mesh, others);
    expect_none(geometry::SlabSink{property.view()});
}

INSTANTIATE_TEST_SUITE_P(meshes, SteadySweep,
                         testing::Combine(testing::ValuesIn(all_meshes()), testing::ValuesIn(sweep_ways)),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

} // namespace
} // namespace ciel::test
