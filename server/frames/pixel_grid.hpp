// Step of the grid on which a view's polygons are sent (wire/batches/quantize.hpp).
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"

namespace ciel::frames {

// Returns the grid step that this camera needs, in length units. The step is a power of two. It is at most a quarter of
// a pixel at the nearest visible triangle, line or point. Rounding by half a step along each axis then moves no point
// by more than 0.22 pixels.
// The step is also at most 1/32 of the height of triangles that are lit without normals, because their shading would
// show the rounding.
// Exception: the step is never less than the resolution of floats at the position and target of the camera, and never
// less than 2^-29 of the largest offset from the origin. Reads all positions.
[[nodiscard]] double needed_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                 const geometry::ViewSize& size);

// Returns a grid step that is fine enough in pixels for this camera, computed only from the bounds. This avoids reading
// all positions each time the camera turns around a large mesh. Returns 0 if a corner of the bounds is not in front of
// the camera. Ignores triangles that are lit without normals, because needed_grid() has already made the grid fine
// enough for them.
[[nodiscard]] double surely_fine_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                      const geometry::ViewSize& size);

// Returns the length of a pixel at the depth of the nearest visible point, in length units. The depth is taken to be at
// least 1e-4 of the depth of the farthest corner of the bounds.
[[nodiscard]] double nearest_pixel(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                   const geometry::ViewSize& size);

} // namespace ciel::frames
