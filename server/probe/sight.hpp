// Polygons on the line of sight through a pixel, without a picture: which layer, and which patch of the boundary.
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

// The pixel is counted from the top left. Ascending by distance, without what clip planes cut away and what the view
// cannot show. Lines, points and volumes are not met. Tests every triangle.
[[nodiscard]] std::vector<Crossing> crossings(const geometry::Geometry& geometry, const scene::Scene& scene,
                                              geometry::ViewSize size, std::array<double, 2> pixel);
// The one nearest to a position that the depth buffer gave; none where no polygon is there, but a line or a point.
[[nodiscard]] std::optional<Crossing> crossing_at(const std::vector<Crossing>& crossings,
                                                  const geometry::Geometry& geometry, const Vec3d& position);
// The patch that a surface layer shows there; none on any other layer, and where no patch has the face.
[[nodiscard]] std::optional<std::string> patch_of(const Crossing& crossing, const geometry::Geometry& geometry,
                                                  const scene::Scene& scene, const store::Dataset& dataset);

} // namespace ciel::probe
