// Clip planes of a scene as half-spaces, and polygons clipped by them.
#pragma once

#include "ciel/clip_surface.hpp"
#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Returns the kept half-spaces of the visible clip layers, in drawing order, as offsets from the geometry's origin.
// If at most a sheet of the bounding box remains, within clip_slack, returns one half-space that keeps nothing.
[[nodiscard]] std::vector<HalfSpace> clip_planes(const scene::Scene& scene, const Geometry& geometry);
// Returns the visible clip layers that have caps, in drawing order.
[[nodiscard]] std::vector<const scene::ClipLayer*> capping(const scene::Scene& scene);

// Returns the distance in length units by which points beyond a plane are still kept. Without it, rounding would cut
// caps and slices in the plane itself to pieces.
[[nodiscard]] double clip_slack(const Geometry& geometry);
// Returns the planes, moved out by the slack, as (normal, offset): kept where dot(normal, position) + offset >= 0.
[[nodiscard]] std::vector<std::array<float, 4>> shader_planes(const Geometry& geometry);

// Returns a drawable's polygons, clipped by the planes of `geometry`, with their scalars. `places`: places_of of its
// surface, or empty.
[[nodiscard]] ClippedSurface clipped(const Geometry& geometry, const Drawable& drawable,
                                     std::span<const Vec3d> places = {});

} // namespace ciel::geometry
