// Finds the world position under a pixel of a picture, from the depth buffer.
#pragma once

#include "ciel/cell_locator.hpp"
#include "geometry/geometry.hpp"
#include "geometry/view_size.hpp"
#include "render/renderer.hpp"
#include "scene/checked_scene.hpp"

#include <functional>
#include <optional>

namespace server::frames {

// Returns nothing if the pixel shows the background. `pixel`: coordinates from the top left corner. The depth buffer is
// rounded, so a position outside of the mesh is moved along the line of sight into a cell, by at most 1e-3 of the
// diagonal of the bounds. `check_wanted`: see render::Frame.
[[nodiscard]] std::optional<ciel::Vec3d> position_under(const geometry::Geometry& geometry,
                                                        const scene::CheckedScene& checked, geometry::ViewSize size,
                                                        std::array<double, 2> pixel, const ciel::CellLocator& locator,
                                                        render::Renderer& renderer, std::function<void()> check_wanted);

} // namespace server::frames
