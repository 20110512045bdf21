// The program's stat, lstat and fstat, which count: what is asked of a slow file system for each step adds up.
#pragma once

#include <cstddef>

namespace ciel::test {

[[nodiscard]] std::size_t stat_calls(); // so far, by any thread

} // namespace ciel::test
