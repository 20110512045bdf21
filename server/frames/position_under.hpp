// Where in space a pixel of a picture is, by the depth that was drawn.
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"
#include "probe/locator.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <optional>

namespace ciel::frames {

// The world position under a pixel (`check_wanted` as a frame's; from the top left) of the picture of this size;
// nothing on the background. A position on a boundary comes out of the depth buffer a little outside as often as
// inside: it is moved along the line of sight, by less than a pixel's depth error, to the nearest cell.
[[nodiscard]] std::optional<Vec3d> position_under(const geometry::Geometry& geometry, const scene::Scene& scene,
                                                  geometry::ViewSize size, std::array<double, 2> pixel,
                                                  const probe::Locator& locator, render::Renderer& renderer,
                                                  std::function<void()> check_wanted);

} // namespace ciel::frames
