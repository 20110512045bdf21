#include "store/mesh_counts.hpp"

#include <algorithm>
#include <numeric>

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

std::uint64_t count_edges(const FaceMeshView& mesh) {
    std::vector<std::uint64_t> edges;
    edges.reserve(mesh.face_vertex.size());
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const auto loop = mesh.loop(face);
        Index before = loop.back();
        for (const Index vertex : loop) {
            if (vertex != before)
                edges.push_back(std::uint64_t{std::min(before, vertex)} << 32 | std::max(before, vertex));
            before = vertex;
        }
    }
    std::sort(edges.begin(), edges.end());
    return static_cast<std::uint64_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

std::uint64_t count_components(const FaceMeshView& mesh) {
    std::vector<Index> parent(mesh.cell_count());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](Index cell) {
        while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
        return cell;
    };
    std::uint64_t components = mesh.cell_count();
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] == none) continue;
        const Index a = root(mesh.owner[face]), b = root(mesh.neighbour[face]);
        if (a == b) continue;
        parent[std::max(a, b)] = std::min(a, b);
        --components;
    }
    return components;
}

} // namespace

MeshInfo count_mesh(const FaceMeshView& mesh) {
    MeshInfo info;
    info.vertices = mesh.vertex_count();
    info.faces = mesh.face_count();
    info.cells = mesh.cell_count();
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const bool boundary = mesh.neighbour[face] == none;
        info.boundary_faces += boundary;
        info.half_edges += mesh.loop(face).size() * (boundary ? 1 : 2);
    }
    for (const std::uint8_t type : mesh.cell_types) ++info.cells_by_type[name_of(type)];
    info.edges = count_edges(mesh);
    info.components = count_components(mesh);
    for (std::size_t axis = 0; axis < 3; ++axis)
        info.bounds[2 * axis] = info.bounds[2 * axis + 1] = mesh.origin[axis] + double{mesh.positions[axis]};
    extend_bounds(info.bounds, mesh.origin, mesh.positions);
    return info;
}

void extend_bounds(std::array<double, 6>& bounds, Vec3d origin, std::span<const float> positions) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double at = origin[i % 3] + double{positions[i]};
        bounds[2 * (i % 3)] = std::min(bounds[2 * (i % 3)], at);
        bounds[2 * (i % 3) + 1] = std::max(bounds[2 * (i % 3) + 1], at);
    }
}

} // namespace ciel::store
