// What the end of ciel-import means to the user who waits for it.
#pragma once

#include "importing/importer.hpp"
#include "processes/child_process.hpp"

namespace ciel::importing {

// One sentence for an end that is not success. `input`: the first, by which the import is named.
[[nodiscard]] std::string describe_end(const processes::ChildEnd& end, const std::string& input,
                                       const ImportLimits& limits);

} // namespace ciel::importing
