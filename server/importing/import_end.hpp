// Explains to the user why ciel-import failed.
#pragma once

#include "importing/importer.hpp"
#include "processes/child_process.hpp"

namespace server::importing {

// Returns the error sentence. It names the first input, unless the import was cancelled or ciel-import's own sentence
// is enough. `end`: how ciel-import ended, without success. `values`: the options of ciel-import.
[[nodiscard]] std::string describe_end(const processes::ChildEnd& end, const ImportValues& values,
                                       const ImportLimits& limits);

} // namespace server::importing
