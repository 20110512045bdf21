// How much memory this process may count on.
#pragma once

#include <cstdint>

namespace ciel::store {

// Bytes: what the machine has, or its control group (a container, a service) where that is less.
[[nodiscard]] std::uint64_t machine_memory();

} // namespace ciel::store
