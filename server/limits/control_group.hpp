// Memory limits that the kernel sets for this process by control groups, as in containers and services (cgroups(7)).
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>

namespace server::limits {

// Bytes; the largest number where no limit is set.
struct GroupMemory {
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max(); // least limit of the groups and their ancestors
    std::uint64_t spare = std::numeric_limits<std::uint64_t>::max(); // least free or reclaimable memory of these groups
};

// Reads the control groups of versions 1 and 2. `root`: folder that contains proc and sys; tests give another one.
[[nodiscard]] GroupMemory group_memory(const std::filesystem::path& root = "/");

} // namespace server::limits
