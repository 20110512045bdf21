// The memory available to this process.
#pragma once

#include <cstdint>

namespace server::limits {

// Returns the bytes of the machine's physical memory, or the limit of the control group (a container, a service) if
// this limit is lower.
[[nodiscard]] std::uint64_t machine_memory();

// Returns the resident bytes of heap, stacks and drivers' allocations. Memory pages of files are not counted.
[[nodiscard]] std::uint64_t private_resident_memory();

// Bytes that this process can still allocate; the largest std::uint64_t if there is no limit.
struct SpareMemory {
    std::uint64_t memory = 0;        // free or reclaimable, on the machine and in the control group
    std::uint64_t address_space = 0; // below RLIMIT_AS
};
[[nodiscard]] SpareMemory spare_memory();

// Decides when freed heap memory is returned to the system. malloc counts memory as free that it has returned already.
// Therefore the free bytes and the resident size are compared with their values at the last return. Not thread-safe.
class FreeMemory {
public:
    // Returns whether 32 MiB or more seem to be free and resident. If true, the caller returns the memory to the
    // system, then calls returned() with the new resident size.
    [[nodiscard]] bool is_worth_returning(std::uint64_t free, std::uint64_t resident);
    void returned(std::uint64_t resident) { resident_after_ = resident; }

private:
    // `free_before_` is the value before the return, so that bytes that another thread frees meanwhile count as new.
    std::uint64_t free_before_ = 0, resident_after_ = 0;
};

// Returns freed heap memory to the system as FreeMemory decides. Without this call, malloc keeps it. Thread-safe.
void give_back_free_memory();

} // namespace server::limits
