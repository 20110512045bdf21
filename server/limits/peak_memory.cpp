#include "limits/peak_memory.hpp"

#include "limits/machine_memory.hpp"

#include <algorithm>
#include <chrono>
#include <malloc.h>

namespace server::limits {

PeakMemory::PeakMemory()
    : sampler_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
              (void)bytes();
              std::this_thread::sleep_for(std::chrono::milliseconds(10));
          }
      }) {}

std::uint64_t PeakMemory::restart() {
    const std::scoped_lock lock(mutex_);
    ::malloc_trim(0);
    highest_ = private_resident_memory();
    return highest_;
}

std::uint64_t PeakMemory::bytes() {
    const std::scoped_lock lock(mutex_);
    highest_ = std::max(highest_, private_resident_memory());
    return highest_;
}

} // namespace server::limits
