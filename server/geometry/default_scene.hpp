// The scene with which a dataset is first shown. It depends on the patches and the arrays of the dataset.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "store/loaded.hpp"

#include <nlohmann/json.hpp>

namespace server::geometry {

struct DefaultScene {        // NOLINT(bugprone-exception-escape): moving a json does not throw
    nlohmann::json document; // has a camera, unless the dataset has no step
    BoundingBox box;         // box to which the camera is fitted: of the bodies, or of the mesh
};

// Returns the first scene of a dataset. `name`: name of the dataset in the catalog. Every first scene has an outline.
// If there are bodies (bodies.hpp), the scene shows the last step whose arrays are written and finite. It has the
// bodies, colored by pressure or else by the first scalar that varies. A slice through the bodies is colored by speed.
// A mesh with one layer of cells and no bodies gets a slice within the layer, at the same step.
// Otherwise the scene has an iso-surface of a point scalar that varies, at the first step at which it varies. The
// surface is colored by another scalar if there is one. The iso-value is halfway between the 5th and 95th percentile,
// so that it is not the value of a plateau, such as the free stream. If no scalar varies, the scene has the boundary of
// the mesh.
[[nodiscard]] DefaultScene default_scene(store::LoadedDataset& loaded, const std::string& name);

} // namespace server::geometry
