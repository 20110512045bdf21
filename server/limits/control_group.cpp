#include "limits/control_group.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace server::limits {
namespace {

namespace fs = std::filesystem;

std::optional<std::uint64_t> number_in(const fs::path& file) {
    std::uint64_t number = 0;
    if (std::ifstream(file) >> number) return number;
    return std::nullopt;
}

struct GroupFiles {
    fs::path root, group;
    const char *limit, *used;
};

// Control groups of version 2 have a single hierarchy, whose line in /proc/self/cgroup names no controllers.
std::vector<GroupFiles> control_groups(const fs::path& root) {
    std::vector<GroupFiles> found;
    std::ifstream groups(root / "proc/self/cgroup"); // lines of "number:controllers:group"
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
        const fs::path group = line.substr(second + 1);
        if (controllers == ",,") found.push_back({root / "sys/fs/cgroup", group, "memory.max", "memory.current"});
        if (controllers.find(",memory,") != std::string::npos)
            found.push_back({root / "sys/fs/cgroup/memory", group, "memory.limit_in_bytes", "memory.usage_in_bytes"});
    }
    return found;
}

template <class Visit>
void for_limits(const GroupFiles& files, Visit&& visit) {
    for (fs::path group = files.group;; group = group.parent_path()) {
        const fs::path directory = files.root / group.relative_path();
        if (const auto limit = number_in(directory / files.limit)) visit(directory, *limit);
        if (!group.has_relative_path()) return;
    }
}

// Returns the bytes of inactive memory pages of files. A control group counts them as used, although they are
// reclaimable.
std::uint64_t file_pages(const fs::path& directory) {
    std::ifstream statistics(directory / "memory.stat");
    std::uint64_t number = 0;
    for (std::string name; statistics >> name >> number;)
        if (name == "inactive_file" || name == "total_inactive_file") return number;
    return 0;
}

} // namespace

GroupMemory group_memory(const fs::path& root) {
    GroupMemory least;
    for (const GroupFiles& files : control_groups(root))
        for_limits(files, [&](const fs::path& directory, std::uint64_t limit) {
            const std::uint64_t used = number_in(directory / files.used).value_or(0);
            const std::uint64_t taken = used - std::min(used, file_pages(directory));
            least.limit = std::min(least.limit, limit);
            least.spare = std::min(least.spare, limit - std::min(limit, taken));
        });
    return least;
}

} // namespace server::limits
