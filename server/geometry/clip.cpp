#include "geometry/clip.hpp"

#include "ciel/vector_operators.hpp"
#include "geometry/clip_planes.hpp"
#include "geometry/cut_box.hpp"
#include "scene/rules.hpp"

#include <algorithm>

namespace server::geometry {

using ciel::operator-;

namespace {

// Fraction of the diagonal: about 50 times the rounding error of positions, and 1/50 of a pixel in a large picture.
constexpr double slack_of_diagonal = 5e-6;
constexpr double double_slack = 1e-12; // slack of positions that are doubles, as a fraction of the largest coordinate

// A float larger than the coordinates of any mesh. With an infinite offset, a graphics card would drop everything.
constexpr double farthest = 1e30;

double diagonal(const Geometry& geometry) { return ciel::length(geometry.bounds_max - geometry.bounds_min); }

template <class F>
void for_planes(const scene::CheckedScene& checked, F&& f) {
    for (const scene::Layer& layer : checked.scene().layers)
        if (const auto* clip = std::get_if<scene::ClipLayer>(&layer.kind); clip != nullptr && layer.visible) f(*clip);
}

// A piece that is not thicker than clip_slack has no volume, but the caps on both of its sides would be drawn.
bool leave_a_sheet_at_most(const std::vector<ciel::HalfSpace>& planes, const Geometry& geometry) {
    if (planes.empty()) return false;
    const double slack = clip_slack(geometry);
    const std::vector<ciel::Vec3d> corners = corners_of_cut_box(geometry, planes);
    return std::any_of(planes.begin(), planes.end(), [&](const ciel::HalfSpace& plane) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const ciel::Vec3d& corner) { return distance(plane, corner) <= slack; });
    });
}

} // namespace

std::vector<ciel::HalfSpace> clip_planes(const scene::CheckedScene& checked, const Geometry& geometry) {
    std::vector<ciel::HalfSpace> planes;
    for_planes(checked, [&](const scene::ClipLayer& clip) {
        const scene::Plane plane = plane_of(clip);
        ciel::HalfSpace kept;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            kept.normal[axis] = -plane.normal[axis];
            kept.offset += plane.normal[axis] * (plane.origin[axis] - geometry.origin[axis]);
        }
        kept.offset = std::clamp(kept.offset, -farthest, farthest);
        planes.push_back(kept);
    });
    if (leave_a_sheet_at_most(planes, geometry)) return {{{1, 0, 0}, -farthest}};
    return planes;
}

std::vector<const scene::ClipLayer*> capping(const scene::CheckedScene& checked) {
    std::vector<const scene::ClipLayer*> found;
    for_planes(checked, [&](const scene::ClipLayer& clip) {
        if (clip.caps) found.push_back(&clip);
    });
    return found;
}

double clip_slack(const Geometry& geometry) { return slack_of_diagonal * diagonal(geometry); }

std::vector<std::array<float, 4>> shader_planes(const Geometry& geometry) {
    std::vector<std::array<float, 4>> planes;
    const double slack = clip_slack(geometry);
    for (const ciel::HalfSpace& plane : geometry.clip)
        planes.push_back({static_cast<float>(plane.normal[0]), static_cast<float>(plane.normal[1]),
                          static_cast<float>(plane.normal[2]), static_cast<float>(plane.offset + slack)});
    return planes;
}

ciel::ClippedSurface clipped(const Geometry& geometry, const Drawable& drawable, std::span<const ciel::Vec3d> places) {
    std::vector<ciel::HalfSpace> planes = geometry.clip;
    double slack = clip_slack(geometry);
    if (!places.empty()) {
        for (ciel::HalfSpace& plane : planes) plane.offset -= ciel::dot(plane.normal, geometry.origin);
        // With float positions, the points of caps are off their planes by the rounding of floats.
        if (geometry.double_positions) slack = double_slack * (diagonal(geometry) + ciel::length(geometry.origin));
    }
    return ciel::clip_surface(drawable.shape->surface, drawable.scalars.value_or(store::Values()), planes, slack,
                              places);
}

} // namespace server::geometry
