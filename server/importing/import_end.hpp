// Explains to the user why ciel-import failed.
#pragma once

#include "importing/importer.hpp"
#include "processes/child_process.hpp"

namespace server::importing {

// `end`: the end of a ciel-import without success. `values`: its options; the sentence names the first input.
[[nodiscard]] std::string describe_end(const processes::ChildEnd& end, const ImportValues& values,
                                       const ImportLimits& limits);

} // namespace server::importing
