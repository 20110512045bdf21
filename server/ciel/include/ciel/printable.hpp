// Not in the paper: names from outside, as a sentence can hold them.
#pragma once

#include <string>
#include <string_view>

namespace ciel {

// Control characters as JSON writes them, \u0000 and the like: in a sentence a zero would be its end, and others would
// steer the terminal that it is printed on.
[[nodiscard]] std::string printable(std::string_view text);

} // namespace ciel
