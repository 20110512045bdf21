// The memory available to this process.
#pragma once

#include <cstdint>

namespace ciel::limits {

// Returns the bytes of the machine's memory, or the limit of the control group (a container, a service) if this limit
// is lower.
[[nodiscard]] std::uint64_t machine_memory();

// Bytes that this process can still allocate; the largest std::uint64_t if there is no limit.
struct SpareMemory {
    std::uint64_t memory = 0;        // free or reclaimable, on the machine and in the control group
    std::uint64_t address_space = 0; // below RLIMIT_AS
};
[[nodiscard]] SpareMemory spare_memory();

// Returns freed heap memory to the system, because malloc would keep it. Does so only if 32 MiB or more seem to have
// been freed since the last return, because a return takes some milliseconds. Thread-safe.
void give_back_free_memory();

} // namespace ciel::limits
