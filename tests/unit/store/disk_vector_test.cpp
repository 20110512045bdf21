#include "store/files/disk_vector.hpp"

#include "store/files/local_files.hpp"
#include "support/folder.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace server::store {
namespace {

constexpr std::size_t large = std::size_t{32} << 20;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_shadow = true; // the sanitizer keeps ordinary memory for each byte that is written
#else
constexpr bool has_shadow = false;
#endif

// Bytes of this process's memory that no file holds.
std::size_t own_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("RssAnon:")) return 1024 * std::stoul(line.substr(8));
    return 0;
}

TEST(DiskVector, LargeBuffersAreNoMemoryOfTheProcess) {
    const ciel::test::Folder folder;
    if (has_shadow) GTEST_SKIP() << "a sanitizer keeps memory for each byte that is written";
    if (is_in_memory(folder.path())) GTEST_SKIP() << "the folder of temporary files is memory";
    const std::size_t before = own_memory();
    DiskVector<std::uint32_t> numbers(large / 4, 7, DiskAllocator<std::uint32_t>(folder.path()));
    EXPECT_LT(own_memory(), before + large / 4);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    numbers.push_back(8); // moves to a larger file
    const DiskVector<std::uint32_t> moved = std::move(numbers);
    const DiskVector<std::uint32_t> copy = moved;
    EXPECT_LT(own_memory(), before + large / 4);
    for (const auto* vector : {&moved, &copy}) {
        ASSERT_EQ(vector->size(), large / 4 + 1);
        EXPECT_EQ(vector->front(), 7U);
        EXPECT_EQ((*vector)[large / 4 - 1], 7U);
        EXPECT_EQ(vector->back(), 8U);
    }
}

void expect_ordinary_memory(const DiskAllocator<std::uint64_t>& allocator) {
    const std::size_t before = own_memory();
    const DiskVector<std::uint64_t> numbers(large / 8, 7, allocator);
    EXPECT_GT(own_memory(), before + large / 2);
    EXPECT_EQ(numbers.back(), 7U);
}

TEST(DiskVector, WithoutAFolderTheMemoryIsOrdinary) {
    const ciel::test::Folder folder;
    expect_ordinary_memory(DiskAllocator<std::uint64_t>());
    expect_ordinary_memory(DiskAllocator<std::uint64_t>(folder.path() / "missing"));
}

TEST(DiskVector, AFolderThatIsMemoryIsNoDisk) {
    const std::filesystem::path memory = "/dev/shm";
    if (!is_in_memory(memory)) GTEST_SKIP() << memory << " is no tmpfs";
    expect_ordinary_memory(DiskAllocator<std::uint64_t>(memory));
}

TEST(DiskVector, GrowsFromSmallToLarge) {
    const ciel::test::Folder folder;
    DiskVector<std::uint64_t> numbers{DiskAllocator<std::uint64_t>(folder.path())};
    for (std::uint64_t i = 0; i < 3 * least_bytes_on_disk / sizeof i; ++i) numbers.push_back(i);
    for (std::uint64_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], i);
    numbers.clear();
    numbers.shrink_to_fit();
    EXPECT_EQ(numbers.capacity(), 0U);
}

TEST(DiskVector, MoreThanAnyMemoryIsRefused) {
    DiskAllocator<std::uint64_t> allocator;
    EXPECT_THROW((void)allocator.allocate(std::size_t{1} << 62), std::bad_alloc);
    EXPECT_THROW((void)allocator.allocate(std::size_t{1} << 50), std::bad_alloc);
}

} // namespace
} // namespace server::store
