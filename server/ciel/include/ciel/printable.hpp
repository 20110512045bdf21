// Escapes names from files and clients, so that a message can quote them. Not in the paper.
#pragma once

#include <string>
#include <string_view>

namespace ciel {

// Returns `text` with control characters escaped as in JSON (\u0000). A NUL would end a message, and a terminal that
// prints the message would obey other control characters.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace ciel
