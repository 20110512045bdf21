// Clips a polygon surface by half-spaces (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). File exports clip
// surfaces, so that a file has only the part of a surface that pictures show. Not in the paper.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/values_view.hpp"

namespace ciel {

// The positions p with dot(normal, p) + offset >= 0. `normal` may have any length except 0. If its length is 1,
// `offset` is a distance.
struct HalfSpace {
    Vec3d normal{};
    double offset = 0;
};

struct ClippedSurface {
    Surface surface;            // the kept input vertices come first; only they have entries in surface.points
    std::vector<double> values; // one for each vertex; empty if the input had none
    std::vector<Vec3d> places;  // one for each vertex; empty if the input had none
};

// Returns the part of `surface` inside all half-spaces. Any thread. Throws Error when `values` or `places` has a wrong
// size.
// `values`: one for each vertex, or empty.
// `places`: empty, or the positions of the vertices in double precision, as offsets from any origin. `planes` use the
// origin of `places`, or, without `places`, the origin of surface.positions.
// `slack`: vertices at most this far outside a plane are kept, in the unit of HalfSpace::offset. Without slack,
// rounding would tear a surface that lies in the plane, such as a cap. Values, normals and places are interpolated at
// new vertices. Two polygons that share a side share the new vertex on that side, so that no cracks open. The result
// has no chunks, and no polygon_face unless `planes` is empty. A polygon that is not convex may be clipped into several
// parts. The parts stay one polygon, and edges in the plane join them; the polygon's loop passes each of these edges
// twice.
[[nodiscard]] ClippedSurface clip_surface(const Surface& surface, ValuesView values, std::span<const HalfSpace> planes,
                                          double slack, std::span<const Vec3d> places = {});

} // namespace ciel
