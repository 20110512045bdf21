// Finds the polygons on the line of sight through a pixel, with their layer and patch. Draws no picture.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "geometry/view_size.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ciel::probe {

struct Crossing {
    double distance = 0; // along the line of sight, from the nearest depth that the view shows
    Vec3d position{};    // in the dataset's coordinates
    std::size_t drawable = 0;
    std::array<Index, 3> corners{}; // of the triangle, in the drawable's surface
};

// Returns the crossings by ascending distance, without those that clip planes cut away or that the view cannot show.
// The pixel is counted from the top left. Lines, points and volumes are ignored. Tests every triangle.
[[nodiscard]] std::vector<Crossing> crossings(const geometry::Geometry& geometry, const scene::Scene& scene,
                                              geometry::ViewSize size, std::array<double, 2> pixel);
// Returns the crossing nearest to `position`, which was read from the depth buffer. Returns nothing if none is within
// 0.002 of the bounds' diagonal, for example if a line or a point is drawn at `position`.
[[nodiscard]] std::optional<Crossing> crossing_at(const std::vector<Crossing>& crossings,
                                                  const geometry::Geometry& geometry, const Vec3d& position);
// Returns the patch that a surface layer shows at the crossing; nothing on other layers, on caps, and on faces that are
// in no patch.
[[nodiscard]] std::optional<std::string> patch_of(const Crossing& crossing, const geometry::Geometry& geometry,
                                                  const scene::Scene& scene, const store::Dataset& dataset);

} // namespace ciel::probe
