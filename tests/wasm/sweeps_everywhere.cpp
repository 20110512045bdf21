#include "ciel/cell_limits.hpp"
#include "support/kept.hpp"
#include "support/volume_property.hpp"
#include "wasm/results.hpp"

namespace ciel::test {
using namespace server;
namespace {

void record_slab(const std::string& where, const color::SlabTriangles& slab, Results& results) {
    results.record(where, "vertices", slab.vertices);
    results.record(where, "triangles", slab.triangles);
}

} // namespace

void record_sweeps(const Meshes& meshes, const FieldPair& fields, Results& results) {
    const Field field(meshes.topology, fields.values, kept_by_test);
    const auto swept = [&]<class Sink>(const Sink& sink) {
        std::vector<typename Sink::Out> out;
        sweep(meshes.topology, meshes.view(), field, fields.walk, sink, out);
        return out;
    };
    const auto soup = swept(SoupSink{}), outline = swept(OutlineSink{});
    const auto slices = swept(SliceSink{fields.others});
    const VolumeProperty property(meshes.topology, meshes.view(), {fields.others.begin(), fields.others.end()});
    const auto slabs = swept(geometry::SlabSink{property.view()});
    for (std::size_t i = 0; i < fields.walk.size(); ++i) {
        const std::string where = fields.where + " / sweep at " + std::to_string(fields.walk[i]);
        results.record(where, "soup", soup[i]);
        results.record(where, "outline", outline[i]);
        results.record(where, "slice positions", slices[i].positions);
        results.record(where, "slice property", slices[i].property);
        results.record(where, "slice triangles", slices[i].triangles);
        record_slab(where + " / slab", slabs[i], results);
    }
    CellLimits limits(meshes.topology);
    std::vector<std::array<float, 2>> of_cells;
    for (Index cell = 0; cell < meshes.topology.counts().cells; ++cell)
        of_cells.push_back(limits.of(cell, fields.others));
    results.record(fields.where, "cell limits", of_cells);
    record_slab(fields.where + " / slab boundary", property.boundary(meshes.view()), results);
}

} // namespace ciel::test
