#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "geometry/cut.hpp"

#include <algorithm>
#include <array>

namespace server::geometry {
namespace {

std::vector<ciel::Index> ids_in(const std::vector<std::string>& groups, const store::Dataset& dataset,
                                const store::Step& step) {
    std::vector<ciel::Index> ids;
    for (const store::Group& group : dataset.groups(step.mesh))
        if (group.of == store::Group::Of::faces && std::ranges::find(groups, group.name) != groups.end())
            ids.insert(ids.end(), group.ids.begin(), group.ids.end());
    return ids;
}

} // namespace

ciel::Surface boundary_surface(store::LoadedDataset& loaded, std::size_t step, const ciel::Vec3d& origin,
                               const std::vector<std::string>& groups, std::span<const std::uint8_t> kept) {
    if (groups.empty()) return loaded.boundary_surface(step, kept, origin);
    const auto dataset = loaded.dataset();
    return loaded.surface_of_faces(step, ids_in(groups, *dataset, dataset->steps()[step]), kept, origin);
}

std::shared_ptr<const Shape> triangles_shape(ciel::Surface&& surface) {
    auto shape = std::make_shared<Shape>();
    shape->surface = std::move(surface);
    shape->indices = ciel::triangulate(shape->surface);
    return shape;
}

std::shared_ptr<const Shape> edges_shape(ciel::Surface&& boundary, std::optional<double> angle) {
    auto shape = std::make_shared<Shape>();
    shape->lines = true;
    shape->indices = angle ? ciel::feature_edges(boundary, *angle) : ciel::polygon_edges(boundary);
    shape->surface.positions = std::move(boundary.positions);
    shape->surface.points = std::move(boundary.points);
    return shape;
}

std::shared_ptr<const Shape> points_shape(const ciel::Surface& boundary, std::size_t thinned) {
    auto shape = std::make_shared<Shape>();
    shape->points = true;
    for (std::size_t i = 0; i < boundary.positions.size(); i += thinned) {
        shape->indices.push_back(static_cast<ciel::Index>(shape->surface.positions.size()));
        shape->surface.positions.push_back(boundary.positions[i]);
        shape->surface.points.push_back(boundary.points[i]);
    }
    return shape;
}

std::shared_ptr<const Shape> outline_shape(ciel::Vec3d minimum, ciel::Vec3d maximum, ciel::Vec3d origin) {
    auto shape = std::make_shared<Shape>();
    shape->lines = true;
    for (ciel::Index corner = 0; corner < 8; ++corner) {
        ciel::Vec3f position{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const ciel::Vec3d& side = (corner >> axis & 1) != 0 ? maximum : minimum;
            position[axis] = static_cast<float>(side[axis] - origin[axis]);
        }
        shape->surface.positions.push_back(position);
        for (ciel::Index axis = 0; axis < 3; ++axis) // each edge once, from its lower corner
            if (const ciel::Index bit = ciel::Index{1} << axis; (corner & bit) == 0)
                shape->indices.insert(shape->indices.end(), {corner, corner | bit});
    }
    return shape;
}

} // namespace server::geometry
