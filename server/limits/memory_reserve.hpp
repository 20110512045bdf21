// Memory reserved for the error answer after a failed allocation.
#pragma once

namespace ciel::limits {

// Reserves 4 MiB of heap memory unless they are already reserved. The first operator new that fails releases the
// reserve and tries again; later failures throw std::bad_alloc. The freed 4 MiB serve to answer, log
// and clean up. Thread-safe.
void keep_memory_in_reserve();

} // namespace ciel::limits
