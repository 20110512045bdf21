// Finds the polygons on the camera ray through a pixel, with their layer and patch. Draws no picture.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "geometry/view_size.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace server::probe {

struct Crossing {
    double distance = 0;                  // along the camera ray, from the near plane
    ciel::Vec3d position{};               // in the dataset's coordinates
    std::size_t drawable = 0;             // index in Geometry::drawables
    std::array<ciel::Index, 3> corners{}; // vertices of the triangle in the drawable's surface
};

// Returns the crossings of the camera ray through `pixel`, in ascending order of distance. Leaves out crossings that
// the clip planes cut away or that are not between the near and far planes. `pixel`: (x, y) from the top left corner of
// the picture. Ignores lines, points, volumes and layers with opacity 0. Tests every triangle.
[[nodiscard]] std::vector<Crossing> crossings(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                                              geometry::ViewSize size, std::array<double, 2> pixel);
// `position`: from the depth buffer. Returns nothing if no crossing is within 0.002 of the bounds' diagonal.
[[nodiscard]] std::optional<Crossing> crossing_at(const std::vector<Crossing>& crossings,
                                                  const geometry::Geometry& geometry, const ciel::Vec3d& position);
// Returns nothing for layers that are no surface layers, for caps, and for faces that are in no patch.
[[nodiscard]] std::optional<std::string> patch_of(const Crossing& crossing, const geometry::Geometry& geometry,
                                                  const scene::CheckedScene& checked);

} // namespace server::probe
