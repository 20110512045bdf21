// Datasets by the name that a client gives.
#pragma once

#include "store/catalog.hpp"

namespace server::sessions {

// Throws NotFound if the catalog has no such dataset, and Error if the dataset cannot be opened.
[[nodiscard]] std::shared_ptr<store::LoadedDataset> open_dataset(store::Catalog& catalog, const std::string& name);

} // namespace server::sessions
