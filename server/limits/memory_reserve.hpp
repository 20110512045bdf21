// Memory reserved for the error answer after a failed allocation.
#pragma once

namespace server::limits {

// Reserves 4 MiB of heap memory once. The first operator new that fails releases this memory and tries again. The
// released memory is used to answer, log and clean up. Thread-safe.
void keep_memory_in_reserve();

} // namespace server::limits
