#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "geometry/cut.hpp"

#include <algorithm>
#include <array>

namespace ciel::geometry {
namespace {

std::vector<Index> ids_in(const std::vector<std::string>& groups, const store::Dataset& dataset,
                          const store::Step& step) {
    std::vector<Index> ids;
    for (const store::Group& group : dataset.groups(step.mesh))
        if (group.of == store::Group::Of::faces && std::ranges::find(groups, group.name) != groups.end())
            ids.insert(ids.end(), group.ids.begin(), group.ids.end());
    return ids;
}

} // namespace

Surface boundary_surface(store::LoadedDataset& loaded, std::size_t step, const Vec3d& origin,
                         const std::vector<std::string>& groups, std::span<const std::uint8_t> kept) {
    if (groups.empty()) return loaded.boundary_surface(step, kept, origin);
    const auto dataset = loaded.dataset();
    return loaded.surface_of_faces(step, ids_in(groups, *dataset, dataset->steps()[step]), kept, origin);
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
