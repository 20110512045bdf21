#include "limits/machine_memory.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <memory>
#include <unistd.h>
#include <vector>

namespace ciel::limits {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool own_heap = true; // a sanitizer replaces malloc and keeps what is freed
#else
constexpr bool own_heap = false;
#endif

std::uint64_t resident() {
    std::uint64_t size = 0, pages = 0;
    std::ifstream("/proc/self/statm") >> size >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

constexpr std::size_t piece = 64 << 10, pieces = 4096; // 256 MiB, in pieces that malloc takes from its heap

// Allocates and frees, but keeps the last piece, so that the heap does not shrink at its end. Returns the peak.
std::uint64_t use_and_free(std::vector<std::unique_ptr<char[]>>& kept) {
    std::vector<std::unique_ptr<char[]>> all;
    for (std::size_t i = 0; i < pieces; ++i) {
        all.push_back(std::make_unique_for_overwrite<char[]>(piece));
        std::memset(all.back().get(), 1, piece);
    }
    kept.push_back(std::move(all.back()));
    return resident();
}

TEST(machine_memory, what_was_freed_is_given_back_each_time) {
    if (own_heap) GTEST_SKIP() << "the sanitizer's malloc keeps what is freed";
    std::vector<std::unique_ptr<char[]>> kept;
    for (int turn = 0; turn < 3; ++turn) {
        const std::uint64_t before = resident();
        const std::uint64_t peak = use_and_free(kept);
        ASSERT_GT(peak, before + (std::uint64_t{200} << 20)) << turn;
        give_back_free_memory();
        EXPECT_LT(resident(), before + (std::uint64_t{32} << 20)) << turn;
    }
}

} // namespace
} // namespace ciel::limits
