// Checks the sizes of the arrays that a caller gives to a sink of a sweep. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <string>

namespace ciel {

// Throws Error unless `found` is `wanted`. `what` names the entries in the message.
inline void require_size(std::size_t found, std::size_t wanted, const char* what) {
    if (found != wanted)
        fail("a sweep needs " + std::to_string(wanted) + " " + what + ", not " + std::to_string(found));
}

} // namespace ciel
