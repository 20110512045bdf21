// Replaces stat, lstat and fstat by counting versions, because each call may be slow on a network file system.
#pragma once

#include <cstddef>

namespace ciel::test {

[[nodiscard]] std::size_t stat_calls(); // calls so far, by all threads

} // namespace ciel::test
