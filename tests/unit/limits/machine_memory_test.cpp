#include "limits/machine_memory.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <memory>
#include <unistd.h>
#include <vector>

namespace server::limits {
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

using Pieces = std::vector<std::unique_ptr<char[]>>;

// Allocates 256 MiB. `kept` gets the last piece, so that the heap does not shrink at its end.
Pieces use(Pieces& kept) {
    Pieces all;
    for (std::size_t i = 0; i < pieces; ++i) {
        all.push_back(std::make_unique_for_overwrite<char[]>(piece));
        std::memset(all.back().get(), 1, piece);
    }
    kept.push_back(std::move(all.back()));
    return all;
}

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

TEST(machine_memory, what_was_freed_is_given_back_each_time) {
    if (own_heap) GTEST_SKIP() << "the sanitizer's malloc keeps what is freed";
    Pieces kept;
    for (int turn = 0; turn < 3; ++turn) {
        const std::uint64_t before = resident();
        Pieces used = use(kept);
        ASSERT_GT(resident(), before + 200 * mebibyte) << turn;
        used.clear();
        give_back_free_memory();
        EXPECT_LT(resident(), before + 32 * mebibyte) << turn;
    }
}

TEST(machine_memory, what_is_in_use_at_a_return_is_given_back_when_it_is_freed) {
    if (own_heap) GTEST_SKIP() << "the sanitizer's malloc keeps what is freed";
    Pieces kept;
    for (int turn = 0; turn < 3; ++turn) {
        const std::uint64_t before = resident();
        Pieces first = use(kept), second = use(kept);
        second.clear();
        give_back_free_memory();
        EXPECT_LT(resident(), before + 300 * mebibyte) << turn;
        first.clear();
        give_back_free_memory();
        EXPECT_LT(resident(), before + 32 * mebibyte) << turn;
    }
}

TEST(free_memory, what_is_freed_during_a_return_is_returned_the_next_time) {
    FreeMemory memory;
    ASSERT_TRUE(memory.is_worth_returning(50 * mebibyte, 200 * mebibyte));
    memory.returned(150 * mebibyte); // another thread has freed 40 MiB meanwhile, which are resident
    EXPECT_TRUE(memory.is_worth_returning(90 * mebibyte, 150 * mebibyte));
    memory.returned(110 * mebibyte);
    EXPECT_FALSE(memory.is_worth_returning(90 * mebibyte, 110 * mebibyte)); // malloc still counts these bytes as free
}

TEST(free_memory, what_is_used_again_and_freed_is_returned) {
    FreeMemory memory;
    ASSERT_TRUE(memory.is_worth_returning(100 * mebibyte, 200 * mebibyte));
    memory.returned(100 * mebibyte);
    EXPECT_TRUE(memory.is_worth_returning(100 * mebibyte, 140 * mebibyte)); // used and freed since
    memory.returned(100 * mebibyte);
    EXPECT_FALSE(memory.is_worth_returning(10 * mebibyte, 190 * mebibyte)); // in use
    EXPECT_TRUE(memory.is_worth_returning(60 * mebibyte, 190 * mebibyte));
}

} // namespace
} // namespace server::limits
