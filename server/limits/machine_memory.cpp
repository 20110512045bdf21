#include "limits/machine_memory.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace ciel::limits {
namespace {

namespace fs = std::filesystem;

std::uint64_t physical_memory() {
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

// Returns the number in a file of a control group; nothing if the file says "max" or does not exist.
std::optional<std::uint64_t> number_in(const fs::path& file) {
    std::uint64_t number = 0;
    if (std::ifstream(file) >> number) return number;
    return std::nullopt;
}

struct GroupFiles {
    fs::path root, group;
    const char *limit, *used;
};

// Returns the memory control groups of this process. Version 2 has a single hierarchy without controller names.
std::vector<GroupFiles> control_groups() {
    std::vector<GroupFiles> found;
    std::ifstream groups("/proc/self/cgroup"); // lines of "number:controllers:group"
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
        const fs::path group = line.substr(second + 1);
        if (controllers == ",,") found.push_back({"/sys/fs/cgroup", group, "memory.max", "memory.current"});
        if (controllers.find(",memory,") != std::string::npos)
            found.push_back({"/sys/fs/cgroup/memory", group, "memory.limit_in_bytes", "memory.usage_in_bytes"});
    }
    return found;
}

// Calls visit(directory, limit) for the group and its ancestors that have a limit.
template <class Visit>
void for_limits(const GroupFiles& files, Visit&& visit) {
    for (fs::path group = files.group;; group = group.parent_path()) {
        const fs::path directory = files.root / group.relative_path();
        if (const auto limit = number_in(directory / files.limit)) visit(directory, *limit);
        if (!group.has_relative_path()) return;
    }
}

// Returns the bytes of inactive file pages, which a control group counts as used although they are reclaimable.
std::uint64_t file_pages(const fs::path& directory) {
    std::ifstream statistics(directory / "memory.stat");
    std::uint64_t number = 0;
    for (std::string name; statistics >> name >> number;)
        if (name == "inactive_file" || name == "total_inactive_file") return number;
    return 0;
}

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

// Returns the bytes of this process's memory that are not pages of a file: heap, stacks and allocations of drivers.
std::uint64_t private_resident_memory() {
    std::uint64_t size = 0, resident = 0, shared = 0;
    std::ifstream("/proc/self/statm") >> size >> resident >> shared;
    return (resident - std::min(resident, shared)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace

std::uint64_t machine_memory() {
    std::uint64_t least = physical_memory();
    for (const GroupFiles& files : control_groups())
        for_limits(files, [&](const fs::path&, std::uint64_t limit) { least = std::min(least, limit); });
    return least;
}

void give_back_free_memory() {
    constexpr std::uint64_t worth_it = std::uint64_t{64} << 20;
    // malloc counts returned memory as free. So memory that was in use at the last call and freed since raises only the
    // count of free bytes. Memory that was returned at the last call, then used and freed, raises only the resident
    // size.
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

SpareMemory spare_memory() {
    SpareMemory spare{available_on_machine(), spare_address_space()};
    for (const GroupFiles& files : control_groups())
        for_limits(files, [&](const fs::path& directory, std::uint64_t limit) {
            const std::uint64_t used = number_in(directory / files.used).value_or(0);
            const std::uint64_t taken = used - std::min(used, file_pages(directory));
            spare.memory = std::min(spare.memory, limit - std::min(limit, taken));
        });
    return spare;
}

} // namespace ciel::limits
