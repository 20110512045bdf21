// How much memory this process may count on.
#pragma once

#include <cstdint>

namespace ciel::limits {

// Bytes: what the machine has, or its control group (a container, a service) where that is less.
[[nodiscard]] std::uint64_t machine_memory();

// Bytes that this process can still take; the largest number where nothing limits it.
struct SpareMemory {
    std::uint64_t memory = 0;        // that is free or can be freed on the machine, and in the control group
    std::uint64_t address_space = 0; // below RLIMIT_AS
};
[[nodiscard]] SpareMemory spare_memory();

// Gives what was freed back to the system where it has grown to many megabytes since the last time: the heap keeps it
// else for what comes, however large it was. Takes some milliseconds then. Thread-safe.
void give_back_free_memory();

} // namespace ciel::limits
