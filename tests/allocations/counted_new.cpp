#include "allocations/counted_new.hpp"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> asked{0};
std::atomic<std::size_t> failing{never};

std::atomic<std::size_t> large{never}, large_count{0};

void count(std::size_t bytes) {
    if (bytes >= large) ++large_count;
    if (++asked == failing) throw std::bad_alloc();
}

} // namespace

namespace ciel::test {

std::size_t allocations() { return asked; }

LargeAllocations::LargeAllocations(std::size_t bytes) {
    large_count = 0;
    large = bytes;
}
LargeAllocations::~LargeAllocations() { large = never; }
std::size_t LargeAllocations::count() { return large_count; }

FailingAllocation::FailingAllocation(std::size_t nth) { failing = asked + nth; }
FailingAllocation::~FailingAllocation() { failing = never; }
bool FailingAllocation::has_failed() { return asked >= failing; }

} // namespace ciel::test

void* operator new(std::size_t bytes) {
    count(bytes);
    if (void* memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    throw std::bad_alloc();
}
// Called by std::stable_partition. AddressSanitizer's version would not match the operator delete below.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    try {
        return operator new(bytes);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

// Called by vectors of the kernel's 4-component SIMD type.
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    count(bytes);
    const auto step = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(step, (bytes / step + 1) * step)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
