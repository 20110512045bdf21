// Clip planes of a scene as half-spaces, and polygons clipped by them.
#pragma once

#include "ciel/clip_surface.hpp"
#include "geometry/scene_geometry.hpp"

namespace server::geometry {

// Returns the kept half-spaces of the visible clip layers, in drawing order, relative to the geometry's origin.
// If nothing thicker than clip_slack remains of the bounding box, returns one half-space that keeps nothing.
[[nodiscard]] std::vector<ciel::HalfSpace> clip_planes(const scene::CheckedScene& checked, const Geometry& geometry);
// Returns the visible clip layers with caps. The pointers are valid as long as `checked`.
[[nodiscard]] std::vector<const scene::ClipLayer*> capping(const scene::CheckedScene& checked);

// Returns the tolerance of clipping in length units. Without the tolerance, rounding would cut holes into caps and
// slices that lie in a clip plane.
[[nodiscard]] double clip_slack(const Geometry& geometry);
// Returns the clip planes as (normal, offset), moved outwards by clip_slack. A position is kept if dot(normal,
// position) + offset >= 0.
[[nodiscard]] std::vector<std::array<float, 4>> shader_planes(const Geometry& geometry);

// Returns a drawable's polygons, clipped by the planes of `geometry`, with their scalars. `places`: the result of
// places_of() for the drawable's surface; the function then clips in doubles. If `places` is empty, it clips in floats.
[[nodiscard]] ciel::ClippedSurface clipped(const Geometry& geometry, const Drawable& drawable,
                                           std::span<const ciel::Vec3d> places = {});

} // namespace server::geometry
