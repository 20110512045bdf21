// Checks the sizes of arrays that a caller gives to a sink of a sweep. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <string>

namespace ciel::detail {

// Throws Error unless `found` equals `wanted`. `what`: describes the entries of the array in the message.
inline void require_size(std::size_t found, std::size_t wanted, const char* what) {
    if (found != wanted)
        fail("an array for slices must have " + std::to_string(wanted) + " " + what + "; it has " +
             std::to_string(found));
}

} // namespace ciel::detail
