// A mesh with a property, cut into slabs to be drawn as a volume.
#pragma once

#include "geometry/slab_sink.hpp"
#include "render/renderer.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/kept.hpp"
#include "support/views.hpp"
#include "support/volume_property.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace server::render {
using namespace ciel;

using Ray = std::array<Vec3d, 2>; // a point and a unit direction

class VolumeScene {
public:
    VolumeScene(const test::Polyhedra& mesh, const std::function<double(const Vec3d&)>& property)
        : mesh_(assemble(test::view(mesh)).mesh), topology_(mesh_.view()) {
        std::vector<float> values;
        for (std::size_t v = 0; v < mesh_.positions.size(); v += 3)
            values.push_back(
                static_cast<float>(property({mesh_.positions[v], mesh_.positions[v + 1], mesh_.positions[v + 2]})));
        property_ = {topology_, mesh_.view(), std::move(values)};
        boundary_ = property_.boundary(mesh_.view());
    }

    // The result borrows from this scene, until the next call.
    [[nodiscard]] Volume volume(const Vec3d& normal, std::size_t slices) {
        const auto distance = plane_distance(mesh_.view(), {}, normal);
        const Field planes(topology_, distance, test::kept_by_test);
        Volume volume;
        volume.normal = normal;
        volume.first = planes.range()[0];
        volume.thickness = (double{planes.range()[1]} - planes.range()[0]) / static_cast<double>(slices);
        std::vector<double> places;
        for (std::size_t i = 0; i < slices; ++i)
            places.push_back(volume.first + (static_cast<double>(i) + 0.5) * volume.thickness);
        (void)sweep(topology_, mesh_.view(), planes, places, geometry::SlabSink{property_.view()}, slices_, {},
                    test::chosen_algorithm());
        volume.slices = slices_;
        volume.boundary = &boundary_;
        volume.identity = 1;
        volume.revision = ++revision_;
        volume.scale.map = "grayscale";
        volume.shaded = false;
        return volume;
    }

private:
    FaceMesh mesh_;
    Topology topology_;
    test::VolumeProperty property_;
    color::SlabTriangles boundary_;
    std::vector<color::SlabTriangles> slices_;
    static inline std::uint64_t revision_ = 0; // shared by all scenes, because one renderer may draw several
};

inline Vec3d plus(const Vec3d& a, const Vec3d& b, double factor = 1) {
    return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Vec3d unit_of(const Vec3d& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}
inline Vec3d cross_of(const Vec3d& a, const Vec3d& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Ray through the pixel coordinates (x, y), from the nearest visible place on. Does not use the renderer's matrices.
inline Ray ray_of(const Frame& frame, double x, double y) {
    const annotations::ViewCamera& camera = frame.camera;
    const Vec3d ahead = unit_of(plus(camera.target, camera.position, -1));
    const Vec3d right = unit_of(cross_of(ahead, camera.up)), up = cross_of(right, ahead);
    const double across = 2 * x / frame.width - 1, down = 1 - 2 * y / frame.height;
    const double aspect = static_cast<double>(frame.width) / frame.height;
    if (camera.parallel) {
        const double half = camera.parallel_height / 2;
        const Vec3d before_all = plus(camera.position, ahead, -10);
        return {plus(plus(before_all, right, across * half * aspect), up, down * half), ahead};
    }
    const double half = std::tan(camera.fov_degrees * std::acos(-1.0) / 360);
    return {camera.position, unit_of(plus(plus(ahead, right, across * half * aspect), up, down * half))};
}

// Distances along the ray where it enters and leaves the box. The first is at least the second when the ray misses.
inline std::array<double, 2> inside_box(const Ray& ray, const Vec3d& low, const Vec3d& high) {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = (low[axis] - ray[0][axis]) / ray[1][axis], b = (high[axis] - ray[0][axis]) / ray[1][axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return {from, to};
}

} // namespace server::render
