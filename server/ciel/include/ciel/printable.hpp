// Escapes names that come from files and clients, so that a message can quote them. Not in the paper.
#pragma once

#include <string>
#include <string_view>

namespace ciel {

// Returns `text` with control characters escaped as in JSON (\u0000). Reasons: a NUL character would end a message, and
// a terminal would execute other control characters.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace ciel
