// Clips a polygon surface by half-spaces (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). File exports use
// it to write only the part that pictures show. Not in the paper.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/values_view.hpp"

namespace ciel {

// Keeps positions with dot(normal, position) + offset >= 0.
struct HalfSpace {
    Vec3d normal{};
    double offset = 0;
};

struct ClippedSurface {
    Surface surface;            // input vertices that are kept come first; `points` has entries for them only
    std::vector<double> values; // one per vertex; empty if the input had none
    std::vector<Vec3d> places;  // one per vertex; empty if the input had none
};

// Returns the part of `surface` inside all half-spaces. `values`: one per vertex, or empty; throws Error on another
// number. `places`: the positions of the vertices as doubles, relative to any point, or empty; the planes are relative
// to the same point as the places, or, without places, as surface.positions. Any thread.
// Values and normals are interpolated at new vertices. Two polygons that share a side share its new vertex, so no
// cracks open. The result has no chunks.
// Vertices at most `slack` outside a plane are kept. Otherwise rounding would tear a surface that lies in the plane,
// such as a cap. A polygon that is not convex may be clipped into several parts. They stay one polygon, joined by edges
// in the plane that its loop passes twice.
[[nodiscard]] ClippedSurface clip_surface(const Surface& surface, ValuesView values, std::span<const HalfSpace> planes,
                                          double slack, std::span<const Vec3d> places = {});

} // namespace ciel
