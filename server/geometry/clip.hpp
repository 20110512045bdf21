// The clip planes of a scene as what they leave, and what of it polygons keep.
#pragma once

#include "ciel/clip_surface.hpp"
#include "geometry/scene_geometry.hpp"

namespace ciel::geometry {

// Of the visible clip layers, in drawing order, for positions and bounds of `geometry`. One that keeps nothing where
// they leave no more than a sheet of the box, within clip_slack.
[[nodiscard]] std::vector<HalfSpace> clip_planes(const scene::Scene& scene, const Geometry& geometry);
// Those of them that close what they cut open.
[[nodiscard]] std::vector<const scene::ClipLayer*> capping(const scene::Scene& scene);

// What lies this near to a plane stays: caps and slices in the plane itself must not be cut to pieces by rounding.
[[nodiscard]] double clip_slack(const Geometry& geometry);
// (normal, offset) of each plane moved out by the slack, for shaders: kept where dot(normal, position) + offset >= 0.
[[nodiscard]] std::vector<std::array<float, 4>> shader_planes(const Geometry& geometry);

// What the picture shows of a drawable's polygons, with its scalars.
[[nodiscard]] ClippedSurface clipped(const Geometry& geometry, const Drawable& drawable);

} // namespace ciel::geometry
