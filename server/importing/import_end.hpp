// Explains to the user why ciel-import failed.
#pragma once

#include "importing/importer.hpp"
#include "processes/child_process.hpp"

namespace server::importing {

// `end`: the end of a ciel-import without success. `input`: the path of the first input, which the sentence names.
[[nodiscard]] std::string describe_end(const processes::ChildEnd& end, const std::string& input,
                                       const ImportLimits& limits);

} // namespace server::importing
