#include "support/kept.hpp"
#include "support/volume_boundary.hpp"
#include "wasm/results.hpp"

namespace ciel::test {
using namespace server;
namespace {

void record_slab(const std::string& where, const color::SlabMesh& slab, Results& results) {
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
    const std::vector<Vec3f> gradient = vertex_gradients(meshes.topology, meshes.view(), fields.others);
    const std::vector<std::array<float, 2>> limits = cell_limits(meshes.topology, fields.others);
    const geometry::SlabProperty property{fields.others, gradient, limits};
    const auto slabs = swept(geometry::SlabSink{property});
    for (std::size_t i = 0; i < fields.walk.size(); ++i) {
        const std::string where = fields.where + " / sweep at " + std::to_string(fields.walk[i]);
        results.record(where, "soup", soup[i]);
        results.record(where, "outline", outline[i]);
        results.record(where, "slice positions", slices[i].positions);
        results.record(where, "slice property", slices[i].property);
        results.record(where, "slice triangles", slices[i].triangles);
        record_slab(where + " / slab", slabs[i], results);
    }
    results.record(fields.where, "cell limits", limits);
    const BlockBoxes boxes = block_boxes(meshes.topology, meshes.view().positions);
    record_slab(fields.where + " / slab boundary", volume_boundary(meshes.topology, meshes.view(), boxes, property),
                results);
}

} // namespace ciel::test
