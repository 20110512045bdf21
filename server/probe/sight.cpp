#include "probe/sight.hpp"

#include "annotations/camera.hpp"
#include "ciel/vectors.hpp"
#include "geometry/clip.hpp"
#include "geometry/clip_planes.hpp"
#include "geometry/viewpoint.hpp"
#include "store/mesh_questions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace server::probe {
namespace {

// A fraction of the diagonal of the bounds. Covers the error of the depth buffer on surfaces at a grazing angle.
constexpr double same_place = 2e-3;

struct Ray { // from the near plane to the far plane; `from` is an offset from the geometry's origin
    ciel::Vec3d from{}, along{};
};

ciel::Vec3d unprojected(const glm::dmat4& inverse, double x, double y, double z) {
    const glm::dvec4 at = inverse * glm::dvec4(x, y, z, 1);
    return {at.x / at.w, at.y / at.w, at.z / at.w};
}

Ray ray_through(const annotations::Viewpoint& viewpoint, std::array<double, 2> pixel) {
    const auto view = annotations::view_transform(viewpoint);
    const glm::dmat4 inverse = glm::inverse(view.projection * view.view);
    const double x = 2 * (std::floor(pixel[0]) + 0.5) / viewpoint.width - 1;
    const double y = 1 - 2 * (std::floor(pixel[1]) + 0.5) / viewpoint.height;
    Ray ray{unprojected(inverse, x, y, -1), unprojected(inverse, x, y, 1)};
    for (std::size_t k = 0; k < 3; ++k) ray.along[k] -= ray.from[k];
    return ray;
}

ciel::Vec3d between(const ciel::Vec3f& from, const ciel::Vec3d& to) {
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

// Returns the ray's parameter (0 to 1) at its intersection with the triangle (Moeller and Trumbore, 1997).
std::optional<double> met(const Ray& ray, const ciel::Vec3f& a, const ciel::Vec3f& b, const ciel::Vec3f& c) {
    const ciel::Vec3d ab = ciel::arm(a, b);
    const ciel::Vec3d ac = ciel::arm(a, c);
    const ciel::Vec3d across = ciel::cross(ray.along, ac);
    const double area = ciel::dot(ab, across);
    if (area == 0) return {};
    const ciel::Vec3d start = between(a, ray.from);
    const double u = ciel::dot(start, across) / area;
    if (!(u >= 0 && u <= 1)) return {};
    const ciel::Vec3d turned = ciel::cross(start, ab);
    const double v = ciel::dot(ray.along, turned) / area;
    if (!(v >= 0 && u + v <= 1)) return {};
    const double share = ciel::dot(ac, turned) / area;
    return share >= 0 && share <= 1 ? std::optional(share) : std::nullopt;
}

const scene::SurfaceLayer* surface_layer(const std::vector<scene::Layer>& layers, const std::string& id) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const auto& layer) { return layer.id == id; });
    return found == layers.end() ? nullptr : std::get_if<scene::SurfaceLayer>(&found->kind);
}

bool shows(const scene::SurfaceLayer& layer, const store::Group& group) {
    return group.of == store::Group::Of::faces &&
           (layer.groups.empty() ||
            std::find(layer.groups.begin(), layer.groups.end(), group.name) != layer.groups.end());
}

} // namespace

std::vector<Crossing> crossings(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                                geometry::ViewSize size, std::array<double, 2> pixel) {
    const auto width = static_cast<int>(size.width), height = static_cast<int>(size.height);
    if (!(pixel[0] >= 0 && pixel[0] < width && pixel[1] >= 0 && pixel[1] < height)) return {};
    const Ray ray = ray_through(geometry::viewpoint_of(geometry, checked, width, height), pixel);
    const double length = std::sqrt(ciel::dot(ray.along, ray.along));
    const geometry::ClipPlanes cutter(geometry);
    std::vector<Crossing> found;
    for (std::size_t d = 0; d < geometry.drawables.size(); ++d) {
        const geometry::Drawable& drawable = geometry.drawables[d];
        if (!drawable.polygons() || drawable.color[3] <= 0) continue;
        const auto& positions = drawable.shape->surface.positions;
        const auto indices = drawable.indices();
        for (std::size_t i = 0; i + 3 <= indices.size(); i += 3) {
            const auto share = met(ray, positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]);
            if (!share) continue;
            Crossing crossing{*share * length, {}, d, {indices[i], indices[i + 1], indices[i + 2]}};
            ciel::Vec3f offset{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = ray.from[k] + *share * ray.along[k];
                offset[k] = static_cast<float>(at);
                crossing.position[k] = geometry.origin[k] + at;
            }
            if (cutter.keeps(offset)) found.push_back(crossing);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
    return found;
}

std::optional<Crossing> crossing_at(const std::vector<Crossing>& crossings, const geometry::Geometry& geometry,
                                    const ciel::Vec3d& position) {
    ciel::Vec3d diagonal{};
    for (std::size_t k = 0; k < 3; ++k) diagonal[k] = geometry.bounds_max[k] - geometry.bounds_min[k];
    double nearest = same_place * same_place * ciel::dot(diagonal, diagonal);
    std::optional<Crossing> found;
    for (const Crossing& crossing : crossings) {
        ciel::Vec3d off{};
        for (std::size_t k = 0; k < 3; ++k) off[k] = crossing.position[k] - position[k];
        if (ciel::dot(off, off) >= nearest) continue;
        nearest = ciel::dot(off, off);
        found = crossing;
    }
    return found;
}

std::optional<std::string> patch_of(const Crossing& crossing, const geometry::Geometry& geometry,
                                    const scene::CheckedScene& checked) {
    const geometry::Drawable& drawable = geometry.drawables[crossing.drawable];
    const scene::SurfaceLayer* layer = surface_layer(checked.scene().layers, drawable.layer);
    if (layer == nullptr) return {};
    const store::Dataset& dataset = *checked.dataset();
    const store::Step& step = dataset.steps()[geometry.step];
    std::array<ciel::Index, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
        const ciel::EdgePoint& point = drawable.shape->surface.points[crossing.corners[i]];
        if (point.a != point.b) return {}; // a point on an edge: the polygon is part of a cap
        vertices[i] = point.a;
    }
    for (const store::Group& group : dataset.groups(step.mesh)) {
        if (shows(*layer, group) && store::has_face_with(dataset, step, group, vertices)) return group.name;
    }
    return {};
}

} // namespace server::probe
