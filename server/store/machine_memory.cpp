#include "store/machine_memory.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;

std::uint64_t physical_memory() {
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// The least limit from the group up to the root; a file that says "max" or is not there sets none.
std::uint64_t least_limit(const fs::path& root, fs::path group, const char* file, std::uint64_t least) {
    for (;; group = group.parent_path()) {
        std::uint64_t limit = 0;
        if (std::ifstream(root / group.relative_path() / file) >> limit) least = std::min(least, limit);
        if (!group.has_relative_path()) return least;
    }
}

} // namespace

std::uint64_t machine_memory() {
    std::uint64_t least = physical_memory();
    std::ifstream groups("/proc/self/cgroup"); // lines of "number:controllers:group"; version 2 names no controllers
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
        const fs::path group = line.substr(second + 1);
        if (controllers == ",,") least = least_limit("/sys/fs/cgroup", group, "memory.max", least);
        if (controllers.find(",memory,") != std::string::npos)
            least = least_limit("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes", least);
    }
    return least;
}

} // namespace ciel::store
