// How fine the grid must be on which a view's polygons are sent (wire/batches/quantize.hpp).
#pragma once

#include "annotations/camera.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"

namespace ciel::frames {

// In length units: a quarter of a pixel at the nearest triangle, line or point that the camera sees, so that nothing
// moves by more than 0.22 pixels (half a step along each axis). A 32nd of the flat triangles' heights where they are
// lit without normals, whose light would show the rounding otherwise. Never finer than what floats resolve. A power of
// two. Reads all positions.
[[nodiscard]] double needed_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                 const geometry::ViewSize& size);

// Never coarser than needed_grid of the same content at another camera; from the bounds alone, so that a camera that
// turns around a large mesh does not read its positions each time. 0 where the eye is among the bounds.
[[nodiscard]] double surely_fine_grid(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                      const geometry::ViewSize& size);

// The length of a pixel at the nearest thing in view; at a tenth of a thousandth of the farthest where things reach to
// the eye.
[[nodiscard]] double nearest_pixel(const geometry::Geometry& geometry, const annotations::Camera& camera,
                                   const geometry::ViewSize& size);

} // namespace ciel::frames
