// A first view of any dataset that shows something worth looking at.
#pragma once

#include "store/loaded.hpp"

#include <nlohmann/json_fwd.hpp>

namespace ciel::session {

// Outline, obstacles (patches that lie inside the domain) and an iso-surface of the first point scalar that is not
// constant, halfway between the values that 5 % and 95 % of the vertices stay below: a plateau, such as the free
// stream, does not hold it. Coloured by another scalar where there is one. The document has an explicit camera.
// `name`: of the dataset in the catalog.
[[nodiscard]] nlohmann::json default_scene(store::LoadedDataset& loaded, const std::string& name);

} // namespace ciel::session
