// The scene that a dataset is first shown with, chosen from its patches and arrays.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "store/loaded.hpp"

#include <nlohmann/json.hpp>

namespace ciel::geometry {

struct DefaultScene {        // NOLINT(bugprone-exception-escape): moving a json does not throw
    nlohmann::json document; // with an explicit camera
    BoundingBox box;         // what the camera looks at: the bodies, or the whole mesh
};

// Returns the first scene of a dataset. `name`: name of the dataset in the catalog. Every first scene has an outline.
// With bodies (bodies.hpp): the last step whose arrays are written and finite; the bodies, colored by pressure or else
// by the first scalar that varies; one slice through them, colored by speed; the camera on them.
// Without bodies, in a mesh of one layer of cells: a slice within the layer, at the same step as with bodies.
// Otherwise: an iso-surface of the first point scalar that varies, at the first step at which it does, colored by
// another scalar if there is one. The iso-value is halfway between the 5th and 95th percentile of the values at
// vertices. So it is not the value of a plateau, such as the free stream. If no scalar varies: the boundary.
[[nodiscard]] DefaultScene default_scene(store::LoadedDataset& loaded, const std::string& name);

} // namespace ciel::geometry
