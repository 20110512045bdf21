#include "limits/machine_memory.hpp"

#include "limits/control_group.hpp"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace server::limits {
namespace {

std::uint64_t physical_memory() {
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t available_on_machine() {
    std::ifstream information("/proc/meminfo"); // lines of "Name: number kB"
    std::string name, unit;
    for (std::uint64_t number = 0; information >> name >> number && std::getline(information, unit);)
        if (name == "MemAvailable:") return number * 1024;
    return unlimited;
}

std::uint64_t spare_address_space() {
    rlimit limit{};
    std::uint64_t pages = 0; // address space of the process
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    if (!(std::ifstream("/proc/self/statm") >> pages)) return unlimited;
    const std::uint64_t used = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}

// Heap, stacks and allocations of drivers, but no memory pages of files.
std::uint64_t private_resident_memory() {
    std::uint64_t size = 0, resident = 0, shared = 0;
    std::ifstream("/proc/self/statm") >> size >> resident >> shared;
    return (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace

std::uint64_t machine_memory() { return std::min(physical_memory(), group_memory().limit); }

void give_back_free_memory() {
    constexpr std::uint64_t worth_it = std::uint64_t{32} << 20;
    // malloc also counts memory as free that it has returned to the system. Therefore the free bytes and the resident
    // size are compared with their values after the last return.
    static std::atomic<std::uint64_t> free_after{0}, size_after{0};
    const auto free_bytes = []() -> std::uint64_t { return ::mallinfo2().fordblks; };
    const std::uint64_t free_now = free_bytes(), size_now = private_resident_memory();
    if (free_now >= free_after + worth_it || (free_now >= worth_it && size_now >= size_after + worth_it)) {
        ::malloc_trim(0);
        free_after = free_bytes();
        size_after = private_resident_memory();
    } else {
        free_after = std::min(free_after.load(), free_now);
        size_after = std::min(size_after.load(), size_now);
    }
}

SpareMemory spare_memory() { return {std::min(available_on_machine(), group_memory().spare), spare_address_space()}; }

} // namespace server::limits
