// What the end of ciel-import means to the user who waits for it.
#pragma once

#include "store/child_process.hpp"
#include "store/importer.hpp"

namespace ciel::store {

// One sentence for an end that is not success. `input`: the first, by which the import is named.
[[nodiscard]] std::string describe_end(const ChildEnd& end, const std::string& input, const ImportLimits& limits);

} // namespace ciel::store
