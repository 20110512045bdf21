// Step of the grid on which a view's polygons are sent (wire/batches/quantize.hpp).
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"

namespace ciel::frames {

// Returns the grid step that this camera needs, in length units: a power of two, never finer than floats resolve at the
// camera's position and target, nor than 2^-29 of the largest offset from the origin. Else the step is at most a
// quarter of a pixel at the nearest visible triangle, line or point. Rounding half a step along each axis then moves
// nothing by more than 0.22 pixels.
// The step is also at most 1/32 of the height of triangles that are lit without normals, because their shading would
// show the rounding. Reads all positions.
[[nodiscard]] double needed_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                 const geometry::ViewSize& size);

// Returns a grid step that is fine enough in pixels for this camera, from the bounds alone. So turning the camera
// around a large mesh does not read all positions each time. Returns 0 if a corner of the bounds is not in front of the
// eye. Ignores triangles lit without normals: the grid that needed_grid made for the same content is fine enough for
// them.
[[nodiscard]] double surely_fine_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                      const geometry::ViewSize& size);

// Returns the length of a pixel at the depth of the nearest visible point, in length units. The depth counts as at
// least 1e-4 of the farthest.
[[nodiscard]] double nearest_pixel(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                   const geometry::ViewSize& size);

} // namespace ciel::frames
