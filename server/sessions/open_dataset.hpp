#pragma once

#include "store/catalog.hpp"

namespace ciel::sessions {

// Throws NotFound when the catalog has no such name, Error when it has and the dataset cannot be opened.
[[nodiscard]] std::shared_ptr<store::LoadedDataset> open_dataset(store::Catalog& catalog, const std::string& name);

} // namespace ciel::sessions
