// Memory reserved for the error answer after a failed allocation.
#pragma once

namespace ciel::limits {

// Reserves 4 MiB, and again if they were used since the last call. The first operator new that fails releases them and
// tries once more; later failures throw std::bad_alloc. The rest of the reserve serves to answer, log and clean up.
// Thread-safe.
void keep_memory_in_reserve();

} // namespace ciel::limits
