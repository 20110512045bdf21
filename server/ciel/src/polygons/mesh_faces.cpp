#include "ciel/mesh_faces.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {
std::vector<CellFace> boundary_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    if (!kept.empty()) return threshold_faces(mesh, kept);
    std::vector<CellFace> faces;
    for (Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == none) faces.push_back({face, mesh.owner[face]});
    return faces;
}

std::vector<CellFace> faces_by_id(const FaceMeshView& mesh, std::vector<Index> ids,
                                  std::span<const std::uint8_t> kept) {
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<CellFace> faces;
    for (const Index face : ids)
        if (const Index owner = mesh.owner[face]; kept.empty() || kept[owner] != 0) faces.push_back({face, owner});
    return faces;
}

std::vector<CellFace> boundary_faces_at(const FaceMeshView& mesh, const Field& field, double level, double tolerance) {
    std::vector<CellFace> faces;
    std::vector<Index> loop;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] != none) continue;
        read_loop(mesh, face, loop);
        mesh.load(loop);
        if (std::ranges::all_of(loop, [&](Index vertex) { return std::abs(field.value(vertex) - level) <= tolerance; }))
            faces.push_back({face, mesh.owner[face]});
    }
    return faces;
}

Index face_with_vertices(const FaceMeshView& mesh, std::span<const Index> ids, std::span<const Index> vertices) {
    const auto has_all = [&](Index face) {
        const Ids loop = mesh.loop(face);
        return std::ranges::all_of(
            vertices, [&](Index vertex) { return std::find(loop.begin(), loop.end(), vertex) != loop.end(); });
    };
    const auto found = std::find_if(ids.begin(), ids.end(), has_all);
    return found == ids.end() ? none : *found;
}

Surface vertices_of_cells(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    std::vector<std::uint8_t> used(mesh.vertex_count());
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const Index neighbour = mesh.neighbour[face];
        if (!kept.empty() && kept[mesh.owner[face]] == 0 && (neighbour == none || kept[neighbour] == 0)) continue;
        for (const Index vertex : mesh.loop(face)) used[vertex] = 1;
    }
    Surface out;
    for (Index vertex = 0; vertex < used.size(); ++vertex) {
        if (used[vertex] == 0) continue;
        out.positions.push_back(surface_position(mesh, vertex));
        out.points.push_back({vertex, vertex, 0});
    }
    return out;
}

FacesSize size_of_faces(const FaceMeshView& mesh, std::span<const Index> ids) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    FacesSize size{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, 0};
    std::vector<Index> loop;
    for (const Index face : ids) {
        read_loop(mesh, face, loop);
        mesh.load(loop);
        for (const Index vertex : loop) {
            const Vec3d at = mesh.origin + position(mesh, vertex);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                size.low[axis] = std::min(size.low[axis], at[axis]);
                size.high[axis] = std::max(size.high[axis], at[axis]);
            }
        }
        if (!loop.empty()) size.area += length(face_shape(mesh, loop).area);
    }
    return size;
}

} // namespace ciel
