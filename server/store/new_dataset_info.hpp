// The id, the time and the texts of a new dataset.
#pragma once

#include "store/writer.hpp"

namespace server::store {

// The id is random. Bytes of the header that are not UTF-8 are replaced.
[[nodiscard]] DatasetInfo new_dataset_info(const DatasetHeader& header);

} // namespace server::store
