// A first view of any dataset that shows something worth looking at.
#pragma once

#include "geometry/scene_geometry.hpp"
#include "store/loaded.hpp"

#include <nlohmann/json.hpp>

namespace ciel::geometry {

struct DefaultScene {        // NOLINT(bugprone-exception-escape): of what a json moves, nothing throws
    nlohmann::json document; // with an explicit camera
    BoundingBox box;         // what the camera looks at: the bodies, or the whole mesh
};

// With bodies (bodies.hpp): the last step whose arrays are written and finite; the bodies, colored by pressure or else
// by the first scalar that varies; one slice through them, colored by speed; the camera on them.
// Without: an iso-surface of the first point scalar that is not constant, at the first step where it is not, halfway
// between the values that 5 % and 95 % of the vertices stay below: a plateau, such as the free stream, does not hold
// it. Colored by another scalar where there is one. An outline in both. `name`: of the dataset in the catalog.
[[nodiscard]] DefaultScene default_scene(store::LoadedDataset& loaded, const std::string& name);

} // namespace ciel::geometry
