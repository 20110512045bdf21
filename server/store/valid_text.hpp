// Replaces the bytes that are not UTF-8 in the texts of a dataset, which are stored as JSON.
#pragma once

#include "store/writer.hpp"

namespace server::store {

[[nodiscard]] ArrayInfo with_valid_text(const ArrayInfo& info);
[[nodiscard]] std::vector<NamedGroup> with_valid_text(std::span<const NamedGroup> groups);

} // namespace server::store
