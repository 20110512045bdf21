// Clips a polygon surface by half-spaces (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974). Exports to a file
// the part that pictures show. Not in the paper.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

struct HalfSpace { // kept: dot(normal, position) + offset >= 0; position is an offset from the mesh's origin
    Vec3d normal{};
    double offset = 0;
};

struct ClippedSurface {
    Surface surface; // vertices that stay come first; `points` has entries for these only
    std::vector<float> values;
};

// Returns a surface that owns its data. `values`: one per vertex, or empty; throws Error on another number. Any thread.
// Values and normals are interpolated at new vertices. Two polygons that share a side share its new vertex, so no
// cracks open. Chunks are dropped.
// Vertices within `slack` of a plane count as kept, so that rounding does not cut up a surface in the plane itself,
// such as a cap. A polygon that is not convex may keep a side along the plane that it runs over twice.
[[nodiscard]] ClippedSurface clip_surface(const Surface& surface, std::span<const float> values,
                                          std::span<const HalfSpace> planes, double slack);

} // namespace ciel
