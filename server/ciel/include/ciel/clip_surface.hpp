// A polygon surface cut by half-spaces (Sutherland and Hodgman, Reentrant Polygon Clipping, 1974): what pictures show
// of it, as polygons for a file. Not in the paper.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

struct HalfSpace { // kept: dot(normal, position) + offset >= 0, of positions from the mesh's origin
    Vec3d normal{};
    double offset = 0;
};

struct ClippedSurface {
    Surface surface; // its points are those of the vertices that stay, which come first; new ones have none
    std::vector<float> values;
};

// `values`: one per vertex, or none; throws Error on another number. They and the normals are interpolated at the new
// vertices. Two polygons that share a side share its new vertex, so nothing opens. What lies within `slack` of a plane
// counts as kept: a surface in the plane itself, a cap above all, is not cut to pieces by rounding. A polygon that is
// not convex may keep a side along the plane that it runs over twice. The chunks are not kept. The result owns all that
// it has; any thread.
[[nodiscard]] ClippedSurface clip_surface(const Surface& surface, std::span<const float> values,
                                          std::span<const HalfSpace> planes, double slack);

} // namespace ciel
