// The program's operator new, which counts. In a file of its own: inlined into its callers, g++ takes it for malloc.
#pragma once

#include <cstddef>

namespace ciel::test {

[[nodiscard]] std::size_t allocations(); // so far, by any thread

} // namespace ciel::test
