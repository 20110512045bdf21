#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "ciel/threshold_surface.hpp"
#include "geometry/cut.hpp"

#include <algorithm>
#include <array>

namespace ciel::geometry {
namespace {

std::vector<CellFace> boundary_faces(const store::Dataset& dataset, const store::Step& step,
                                     const std::vector<std::string>& names, std::span<const std::uint8_t> kept) {
    const FaceMeshView mesh = dataset.mesh(step.mesh, step.coordinates);
    std::vector<CellFace> faces;
    if (names.empty()) {
        if (!kept.empty()) return threshold_faces(mesh, kept);
        for (Index face = 0; face < mesh.face_count(); ++face)
            if (mesh.neighbour[face] == none) faces.push_back({face, mesh.owner[face]});
        return faces;
    }
    std::vector<Index> ids;
    for (const store::Group& group : dataset.groups(step.mesh))
        if (group.of == store::Group::Of::faces && std::find(names.begin(), names.end(), group.name) != names.end())
            ids.insert(ids.end(), group.ids.begin(), group.ids.end());
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    for (const Index face : ids)
        if (const Index owner = mesh.owner[face]; kept.empty() || kept[owner] != 0) faces.push_back({face, owner});
    return faces;
}

} // namespace

Surface boundary_surface(const store::Dataset& dataset, const store::Step& step, const std::vector<std::string>& groups,
                         std::span<const std::uint8_t> kept) {
    return face_surface(dataset.mesh(step.mesh, step.coordinates), boundary_faces(dataset, step, groups, kept));
}

std::shared_ptr<const Shape> triangles_shape(Surface&& surface) {
    auto shape = std::make_shared<Shape>();
    shape->surface = std::move(surface);
    shape->indices = triangulate(shape->surface);
    return shape;
}

std::shared_ptr<const Shape> edges_shape(Surface&& boundary, std::optional<double> angle) {
    auto shape = std::make_shared<Shape>();
    shape->lines = true;
    shape->indices = angle ? feature_edges(boundary, *angle) : polygon_edges(boundary);
    shape->surface.positions = std::move(boundary.positions);
    shape->surface.points = std::move(boundary.points);
    return shape;
}

std::shared_ptr<const Shape> points_shape(const Surface& boundary, std::size_t thinned) {
    auto shape = std::make_shared<Shape>();
    shape->points = true;
    for (std::size_t i = 0; i < boundary.positions.size(); i += thinned) {
        shape->indices.push_back(static_cast<Index>(shape->surface.positions.size()));
        shape->surface.positions.push_back(boundary.positions[i]);
        shape->surface.points.push_back(boundary.points[i]);
    }
    return shape;
}

Surface cell_vertices(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    std::vector<std::uint8_t> used(mesh.vertex_count());
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const Index neighbour = mesh.neighbour[face];
        if (!kept.empty() && kept[mesh.owner[face]] == 0 && (neighbour == none || kept[neighbour] == 0)) continue;
        for (const Index vertex : mesh.loop(face)) used[vertex] = 1;
    }
    Surface out;
    for (Index vertex = 0; vertex < used.size(); ++vertex) {
        if (used[vertex] == 0) continue;
        const float* at = &mesh.positions[std::size_t{3} * vertex];
        out.positions.push_back({at[0], at[1], at[2]});
        out.points.push_back({vertex, vertex, 0});
    }
    return out;
}

std::shared_ptr<const Shape> outline_shape(Vec3d minimum, Vec3d maximum, Vec3d origin) {
    auto shape = std::make_shared<Shape>();
    shape->lines = true;
    for (Index corner = 0; corner < 8; ++corner) {
        Vec3f position{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vec3d& side = (corner >> axis & 1) != 0 ? maximum : minimum;
            position[axis] = static_cast<float>(side[axis] - origin[axis]);
        }
        shape->surface.positions.push_back(position);
        for (Index axis = 0; axis < 3; ++axis) // each edge once, from its lower corner
            if (const Index bit = Index{1} << axis; (corner & bit) == 0)
                shape->indices.insert(shape->indices.end(), {corner, corner | bit});
    }
    return shape;
}

} // namespace ciel::geometry
