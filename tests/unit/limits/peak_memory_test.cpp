#include "limits/peak_memory.hpp"

#include <chrono>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace server::limits {
namespace {

constexpr std::size_t size = 128 << 20;
constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
#ifdef __SANITIZE_THREAD__
constexpr bool has_shadow = true; // each byte that is written takes several bytes more
#else
constexpr bool has_shadow = false;
#endif

std::unique_ptr<char[]> used_memory() {
    auto memory = std::make_unique_for_overwrite<char[]>(size);
    std::memset(memory.get(), 1, size);
    return memory;
}

// Waits until the sampler, which reads the memory every 10 ms, has seen the memory that is in use now.
void wait_for(PeakMemory& peak, std::uint64_t bytes) {
    for (int i = 0; i < 1000 && peak.bytes() < bytes; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

TEST(peak_memory, is_kept_after_the_memory_is_freed) {
    if (has_shadow) GTEST_SKIP() << "ThreadSanitizer keeps memory for each byte that is written";
    PeakMemory peak;
    const std::uint64_t before = peak.restart();
    auto memory = used_memory();
    wait_for(peak, before + 120 * mebibyte);
    memory.reset();
    EXPECT_GT(peak.bytes(), before + 120 * mebibyte);
    EXPECT_LT(peak.bytes(), before + 160 * mebibyte);
}

TEST(peak_memory, is_noticed_by_the_sampler) {
    PeakMemory peak;
    const std::uint64_t before = peak.restart();
    auto memory = used_memory();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    memory.reset();
    EXPECT_GT(peak.bytes(), before + 120 * mebibyte);
}

TEST(peak_memory, begins_again_at_a_restart) {
    PeakMemory peak;
    const auto kept = used_memory();
    auto memory = used_memory();
    (void)peak.bytes();
    memory.reset();
    const std::uint64_t in_use = peak.restart();
    EXPECT_GT(in_use, 120 * mebibyte); // `kept`
    EXPECT_LT(peak.bytes(), in_use + 32 * mebibyte);
}

} // namespace
} // namespace server::limits
