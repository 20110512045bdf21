// PeakMemory: the highest private memory of this process since construction or restart().
#pragma once

#include <cstdint>
#include <mutex>
#include <thread>

namespace server::limits {

// A thread reads private_resident_memory() every 10 ms. A shorter peak can be missed. Thread-safe.
class PeakMemory {
public:
    PeakMemory(); // throws std::system_error if no thread can be started

    // Returns freed heap memory to the system, and begins again. Returns the bytes that are in use.
    std::uint64_t restart();
    // Returns the highest number of bytes since the last restart, or since the construction.
    [[nodiscard]] std::uint64_t bytes();

private:
    std::mutex mutex_;
    std::uint64_t highest_ = 0;
    std::jthread sampler_; // last, so that it ends first
};

} // namespace server::limits
