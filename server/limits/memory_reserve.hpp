// Memory reserved for the error answer after a failed allocation.
#pragma once

namespace ciel::limits {

// Reserves 4 MiB of heap memory, unless this memory is already reserved. The first operator new that fails releases the
// reserve and tries again. Later failures throw std::bad_alloc. The released 4 MiB are used to answer, log and clean
// up. Thread-safe.
void keep_memory_in_reserve();

} // namespace ciel::limits
