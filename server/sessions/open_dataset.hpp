#pragma once

#include "store/catalog.hpp"

namespace ciel::sessions {

// Opens a dataset of the catalog. Throws NotFound when the catalog has no dataset of this name, Error when the dataset
// cannot be opened.
[[nodiscard]] std::shared_ptr<store::LoadedDataset> open_dataset(store::Catalog& catalog, const std::string& name);

} // namespace ciel::sessions
