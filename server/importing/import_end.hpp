// Explains to the user how ciel-import ended.
#pragma once

#include "importing/importer.hpp"
#include "processes/child_process.hpp"

namespace ciel::importing {

// Returns one sentence for an end without success. `input`: the first input, which names the import.
[[nodiscard]] std::string describe_end(const processes::ChildEnd& end, const std::string& input,
                                       const ImportLimits& limits);

} // namespace ciel::importing
