// Memory limits in made control groups: both versions, ancestors, groups without a limit, pages that are reclaimable.
#include "limits/control_group.hpp"

#include "support/folder.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace server::limits {
using namespace ciel;
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

class ControlGroup : public testing::Test {
protected:
    void write(const std::string& path, const std::string& text) const {
        std::filesystem::create_directories((folder_ / path).parent_path());
        std::ofstream(folder_ / path) << text;
    }
    [[nodiscard]] GroupMemory read() const { return group_memory(folder_.path()); }

private:
    test::Folder folder_;
};

TEST_F(ControlGroup, WithoutAnyThereIsNoLimit) {
    EXPECT_EQ(read().limit, unlimited);
    EXPECT_EQ(read().spare, unlimited);
}

TEST_F(ControlGroup, TheLimitOfVersion2Counts) {
    write("proc/self/cgroup", "0::/system.slice/ciel.service\n");
    write("sys/fs/cgroup/system.slice/ciel.service/memory.max", "4000\n");
    write("sys/fs/cgroup/system.slice/ciel.service/memory.current", "1500\n");
    EXPECT_EQ(read().limit, 4000U);
    EXPECT_EQ(read().spare, 2500U);
}

TEST_F(ControlGroup, PagesOfFilesThatAreNotInUseAreSpare) {
    write("proc/self/cgroup", "0::/\n");
    write("sys/fs/cgroup/memory.max", "4000\n");
    write("sys/fs/cgroup/memory.current", "3900\n");
    write("sys/fs/cgroup/memory.stat", "anon 900\nfile 3000\ninactive_file 2900\nactive_file 100\n");
    EXPECT_EQ(read().spare, 3000U);
}

TEST_F(ControlGroup, TheLeastLimitOfTheAncestorsCounts) {
    write("proc/self/cgroup", "0::/a/b\n");
    write("sys/fs/cgroup/a/b/memory.max", "max\n");
    write("sys/fs/cgroup/a/memory.max", "3000\n");
    write("sys/fs/cgroup/a/memory.current", "5000\n"); // more than a limit that was lowered
    write("sys/fs/cgroup/memory.max", "7000\n");
    EXPECT_EQ(read().limit, 3000U);
    EXPECT_EQ(read().spare, 0U);
}

TEST_F(ControlGroup, VersionOneHasAHierarchyForMemory) {
    write("proc/self/cgroup", "12:cpu,cpuacct:/x\n7:memory:/docker/1a\n0::/\nnonsense\n");
    write("sys/fs/cgroup/memory/docker/1a/memory.limit_in_bytes", "2000\n");
    write("sys/fs/cgroup/memory/docker/1a/memory.usage_in_bytes", "700\n");
    write("sys/fs/cgroup/memory/docker/1a/memory.stat", "rss 500\ntotal_inactive_file 200\n");
    EXPECT_EQ(read().limit, 2000U);
    EXPECT_EQ(read().spare, 1500U);
}

} // namespace
} // namespace server::limits
