#include "allocations/counted_new.hpp"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <link.h>
#include <malloc.h>
#include <new>
#include <string_view>

namespace {

struct AddressRange {
    std::size_t begin = 0, end = 0;
};

// Where the code of TBB is in memory, or an empty range.
AddressRange addresses_of_tbb() {
    AddressRange out;
    dl_iterate_phdr(
        [](dl_phdr_info* library, std::size_t, void* result) {
            if (std::string_view(library->dlpi_name).find("/libtbb.so") == std::string_view::npos) return 0;
            for (int i = 0; i < library->dlpi_phnum; ++i) {
                const auto& part = library->dlpi_phdr[i];
                if ((part.p_flags & PF_X) == 0) continue;
                const std::size_t begin = library->dlpi_addr + part.p_vaddr;
                *static_cast<AddressRange*>(result) = {begin, begin + part.p_memsz};
            }
            return 1;
        },
        &out);
    return out;
}
const AddressRange tbb = addresses_of_tbb();

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> asked{0};
std::atomic<std::size_t> failing{never};

std::atomic<std::size_t> large{never}, large_count{0};

std::atomic<bool> weighs{false};
std::atomic<std::ptrdiff_t> held{0}, most_held{0};

void* weigh(void* memory) {
    if (!weighs) return memory;
    const std::ptrdiff_t now = held += static_cast<std::ptrdiff_t>(::malloc_usable_size(memory));
    for (std::ptrdiff_t most = most_held; now > most && !most_held.compare_exchange_weak(most, now);) {
    }
    return memory;
}
void give_back(void* memory) {
    if (weighs) held -= static_cast<std::ptrdiff_t>(::malloc_usable_size(memory));
    std::free(memory);
}

// Neither counts nor fails TBB's own allocations: an exception while TBB starts a worker would end the process.
void count(std::size_t bytes, const void* caller) {
    const auto address = reinterpret_cast<std::size_t>(caller);
    if (address >= tbb.begin && address < tbb.end) return;
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

PeakBytes::PeakBytes() {
    held = most_held = 0;
    weighs = true;
}
PeakBytes::~PeakBytes() { weighs = false; }
std::size_t PeakBytes::peak() { return static_cast<std::size_t>(most_held.load()); }

FailingAllocation::FailingAllocation(std::size_t nth) { failing = asked + nth; }
FailingAllocation::~FailingAllocation() { failing = never; }
bool FailingAllocation::has_failed() { return asked >= failing; }

} // namespace ciel::test

void* operator new(std::size_t bytes) {
    count(bytes, __builtin_return_address(0));
    if (void* memory = std::malloc(bytes > 0 ? bytes : 1)) return weigh(memory);
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
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }

// Called by vectors of the kernel's 4-component SIMD type.
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    count(bytes, __builtin_return_address(0));
    const auto step = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(step, (bytes / step + 1) * step)) return weigh(memory);
    throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
