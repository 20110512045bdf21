#include "session/cut.hpp"

#include <algorithm>
#include <array>

namespace ciel::session {
namespace {

constexpr Index polygons_per_chunk = 4096;

std::vector<Index> boundary_faces(const store::Dataset& dataset, const store::Step& step,
                                  const std::vector<std::string>& names) {
    std::vector<Index> faces;
    const FaceMeshView mesh = dataset.mesh(step.mesh, step.coordinates);
    if (names.empty()) {
        for (Index face = 0; face < mesh.face_count(); ++face)
            if (mesh.neighbour[face] == none) faces.push_back(face);
        return faces;
    }
    for (const store::Group& group : dataset.groups(step.mesh))
        if (group.of == store::Group::Of::faces && std::find(names.begin(), names.end(), group.name) != names.end())
            faces.insert(faces.end(), group.ids.begin(), group.ids.end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

} // namespace

std::shared_ptr<const Shape> boundary_shape(const store::Dataset& dataset, const store::Step& step,
                                            const std::vector<std::string>& groups) {
    const FaceMeshView mesh = dataset.mesh(step.mesh, step.coordinates);
    auto shape = std::make_shared<Shape>();
    Surface& surface = shape->surface;
    std::vector<Index> local(mesh.vertex_count(), none);
    for (const Index face : boundary_faces(dataset, step, groups)) {
        for (const Index vertex : mesh.loop(face)) {
            if (local[vertex] == none) {
                local[vertex] = static_cast<Index>(surface.positions.size());
                const float* at = &mesh.positions[std::size_t{3} * vertex];
                surface.positions.push_back({at[0], at[1], at[2]});
                surface.points.push_back({vertex, vertex, 0});
            }
            surface.polygon_vertex.push_back(local[vertex]);
        }
        surface.polygon_offset.push_back(static_cast<Index>(surface.polygon_vertex.size()));
        surface.polygon_cell.push_back(mesh.owner[face]);
    }
    const auto polygons = static_cast<Index>(surface.polygon_cell.size());
    for (Index begin = 0; begin < polygons; begin += polygons_per_chunk)
        surface.chunks.push_back({begin / polygons_per_chunk, begin, std::min(begin + polygons_per_chunk, polygons)});
    shape->indices = triangulate(surface);
    return shape;
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

} // namespace ciel::session
