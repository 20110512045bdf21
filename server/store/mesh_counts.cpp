#include "store/mesh_counts.hpp"

#include "store/format/block_index.hpp"

#include <algorithm>

namespace server::store {
namespace {

const char* name_of(std::uint8_t type) {
    switch (static_cast<ciel::CellType>(type)) {
    case ciel::CellType::tetrahedron:
        return "tetrahedron";
    case ciel::CellType::hexahedron:
        return "hexahedron";
    case ciel::CellType::wedge:
        return "wedge";
    case ciel::CellType::pyramid:
        return "pyramid";
    case ciel::CellType::polyhedron:
        return "polyhedron";
    }
    throw ciel::Error("cell type " + std::to_string(type) +
                      " does not exist; use tetrahedron, hexahedron, wedge, pyramid or "
                      "polyhedron");
}

} // namespace

MeshInfo count_mesh(const ciel::FaceMeshView& mesh, const ciel::TopologyCounts& counts,
                    const std::array<double, 6>& bounds) {
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
    info.bounds = bounds;
    return info;
}

std::array<double, 6> bounds_of(ciel::Vec3d origin, ciel::ValuesView positions) {
    std::array<double, 6> bounds;
    for (std::size_t axis = 0; axis < 3; ++axis)
        bounds[2 * axis] = bounds[2 * axis + 1] = origin[axis] + positions[axis];
    extend_bounds(bounds, origin, positions);
    return bounds;
}

void extend_bounds(std::array<double, 6>& bounds, ciel::Vec3d origin, ciel::ValuesView positions) {
    positions.with([&](const auto& all) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double at = origin[i % 3] + double{all[i]};
            bounds[2 * (i % 3)] = std::min(bounds[2 * (i % 3)], at);
            bounds[2 * (i % 3) + 1] = std::max(bounds[2 * (i % 3) + 1], at);
        }
    });
}

std::uint64_t record_bytes(const ciel::Topology& topology) {
    std::uint64_t bytes = 0;
    for (ciel::Index block = 0; block < topology.block_count(); ++block)
        for (const ciel::RecordKind kind : record_kinds) bytes += topology.record(block, kind).size();
    return bytes;
}

} // namespace server::store
