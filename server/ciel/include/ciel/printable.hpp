// Makes names from outside safe to put in a message. Not in the paper.
#pragma once

#include <string>
#include <string_view>

namespace ciel {

// Returns `text` with control characters escaped as in JSON (\u0000). A zero would end a message, and other control
// characters would act on the terminal that prints it.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace ciel
