#include "bench/case.hpp"
#include "store/mesh_counts.hpp"

namespace server::bench {

Table memory_table(const Case& data) {
    const ciel::TopologyCounts& counts = data.topology->counts();
    const auto half_edges = static_cast<double>(counts.half_edges);
    const auto topology_bytes = static_cast<double>(store::record_bytes(*data.topology));

    const ciel::Field field = field_of(data, data.values);
    ciel::Query query(*data.topology, data.mesh);
    query.set_field(field);
    const auto [low, high] = field.range();
    ciel::Surface surface;
    for (const double nu : values_between(low, high, 9)) (void)query.extract(nu, false, surface);

    Table table{"memory", {}, {}};
    table.figures = {
        {"vertices", static_cast<double>(counts.vertices), ""},
        {"edges", static_cast<double>(counts.edges), ""},
        {"faces", static_cast<double>(counts.faces), ""},
        {"cells", static_cast<double>(counts.cells), ""},
        {"half-edges", half_edges, ""},
        {"blocks", static_cast<double>(data.topology->block_count()), ""},
        {"topology", topology_bytes, "bytes"},
        {"topology per half-edge, six operators", topology_bytes / half_edges, "bytes"},
        {"the paper's table", 4, "bytes per half-edge"},
        {"the paper's printed structure, 64 bit", 56, "bytes per half-edge"},
        {"topology in memory, all blocks read", static_cast<double>(data.topology->memory_bytes()), "bytes"},
        {"one viewer's query after 9 values", static_cast<double>(query.memory_bytes()), "bytes"},
    };
    return table;
}

} // namespace server::bench
