// Reads a number that another process may change. Not in the paper.
#pragma once

namespace ciel::detail {

// The numbers of a record or of a mapped mesh may change. Without `volatile`, the compiler may read an element twice,
// and get two different numbers.
template <class T>
[[nodiscard]] inline T read_once(const T& entry) {
    return *const_cast<const volatile T*>(&entry);
}

} // namespace ciel::detail
