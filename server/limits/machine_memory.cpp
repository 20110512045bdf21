#include "limits/machine_memory.hpp"

#include "limits/control_group.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <mutex>
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

} // namespace

std::uint64_t machine_memory() { return std::min(physical_memory(), group_memory().limit); }

std::uint64_t private_resident_memory() {
    std::uint64_t size = 0, resident = 0, shared = 0;
    std::ifstream("/proc/self/statm") >> size >> resident >> shared;
    return (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

bool FreeMemory::is_worth_returning(std::uint64_t free, std::uint64_t resident) {
    constexpr std::uint64_t worth_it = std::uint64_t{32} << 20;
    if (free >= free_before_ + worth_it || (free >= worth_it && resident >= resident_after_ + worth_it)) {
        free_before_ = free;
        return true;
    }
    free_before_ = std::min(free_before_, free);
    resident_after_ = std::min(resident_after_, resident);
    return false;
}

void give_back_free_memory() {
    static std::mutex mutex;
    static FreeMemory free_memory;
    const std::scoped_lock lock(mutex);
    if (!free_memory.is_worth_returning(::mallinfo2().fordblks, private_resident_memory())) return;
    ::malloc_trim(0);
    free_memory.returned(private_resident_memory());
}

SpareMemory spare_memory() { return {std::min(available_on_machine(), group_memory().spare), spare_address_space()}; }

} // namespace server::limits
