// The memory available to this process.
#pragma once

#include <cstdint>

namespace server::limits {

// In bytes. If the limit of the control group (a container, a service) is lower, returns this limit.
[[nodiscard]] std::uint64_t machine_memory();

// Bytes that this process can still allocate; the largest std::uint64_t if there is no limit.
struct SpareMemory {
    std::uint64_t memory = 0;        // free or reclaimable, on the machine and in the control group
    std::uint64_t address_space = 0; // below RLIMIT_AS
};
[[nodiscard]] SpareMemory spare_memory();

// Returns freed heap memory to the system if it seems to be 32 MiB or more. malloc would keep it. Thread-safe.
void give_back_free_memory();

} // namespace server::limits
