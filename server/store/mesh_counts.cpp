#include "store/mesh_counts.hpp"

#include "store/format/block_index.hpp"

#include <algorithm>

namespace ciel::store {
namespace {

const char* name_of(std::uint8_t type) {
    switch (static_cast<CellType>(type)) {
    case CellType::tetrahedron:
        return "tetrahedron";
    case CellType::hexahedron:
        return "hexahedron";
    case CellType::wedge:
        return "wedge";
    case CellType::pyramid:
        return "pyramid";
    case CellType::polyhedron:
        return "polyhedron";
    }
    throw Error("cell type " + std::to_string(type) +
                " does not exist; use tetrahedron, hexahedron, wedge, pyramid or "
                "polyhedron");
}

} // namespace

MeshInfo count_mesh(const FaceMeshView& mesh, const Topology& topology) {
    const TopologyCounts& counts = topology.counts();
    MeshInfo info;
    info.vertices = counts.vertices;
    info.edges = counts.edges;
    info.faces = counts.faces;
    info.half_edges = counts.half_edges;
    info.boundary_faces = counts.boundary_faces;
    info.components = counts.components;
    info.cells = counts.cells;
    info.double_positions = mesh.positions.has_doubles();
    for (const std::uint8_t type : mesh.cell_types) ++info.cells_by_type[name_of(type)];
    for (std::size_t axis = 0; axis < 3; ++axis)
        info.bounds[2 * axis] = info.bounds[2 * axis + 1] = mesh.origin[axis] + mesh.positions[axis];
    extend_bounds(info.bounds, mesh.origin, mesh.positions);
    return info;
}

void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, ValuesView positions) {
    positions.with([&](const auto& all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double at = origin[i % 3] + double{all[i]};
            bounds[2 * (i % 3)] = std::min(bounds[2 * (i % 3)], at);
            bounds[2 * (i % 3) + 1] = std::max(bounds[2 * (i % 3) + 1], at);
        }
    });
}

std::uint64_t record_bytes(const Topology& topology) {
    std::uint64_t bytes = 0;
    for (Index block = 0; block < topology.block_count(); ++block)
        for (const RecordKind kind : record_kinds) bytes += topology.record(block, kind).size();
    return bytes;
}

} // namespace ciel::store
