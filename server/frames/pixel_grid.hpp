// Step of the grid on which a view's polygons are sent (wire/batches/quantize.hpp).
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"

namespace server::frames {

// Returns the grid step that this camera needs, a power of two in length units. It is at most a quarter of a pixel at
// the nearest visible triangle, line or point, so that rounding moves no point by more than 0.22 pixels. It is at most
// 1/32 of the height of triangles that are lit without normals, because their shading would show the rounding. But it
// is never less than the resolution of floats at the camera's position and target, or than 2^-29 of the largest offset
// of the bounds from the origin.
[[nodiscard]] double needed_grid(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                                 const geometry::ViewSize& size);

// Computes a fine enough step from the bounds only, because reading all positions takes long each time the camera
// turns. Returns 0 if a corner of the bounds is not in front of the camera. Ignores triangles that are lit without
// normals, because needed_grid() has already made the grid fine enough for them.
[[nodiscard]] double surely_fine_grid(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                                      const geometry::ViewSize& size);

// Returns the length of a pixel at the nearest visible point. Its depth counts as at least 1e-4 of the largest depth.
[[nodiscard]] double nearest_pixel(const geometry::Geometry& geometry, const annotations::ViewCamera& camera,
                                   const geometry::ViewSize& size);

} // namespace server::frames
