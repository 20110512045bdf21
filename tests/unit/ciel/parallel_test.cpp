// Number of threads that the kernel's parallel loop uses.
#include "ciel/parallel.hpp"
#include "support/thread_count.hpp"

#include <chrono>
#include <condition_variable>
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <thread>

namespace ciel::test {
namespace {

// Number of threads that work on a loop of `tasks` tasks at the same time. No task ends before `wanted` have started.
std::size_t threads_at_once(std::size_t tasks, std::size_t wanted) {
    constexpr std::chrono::seconds patience{20}; // ends the wait when the loop uses fewer threads than wanted
    std::mutex mutex;
    std::condition_variable all_here;
    std::set<std::thread::id> seen;
    parallel_for(tasks, 1, [&](std::size_t, std::size_t) {
        std::unique_lock lock(mutex);
        seen.insert(std::this_thread::get_id());
        all_here.notify_all();
        all_here.wait_for(lock, patience, [&] { return seen.size() >= wanted; });
    });
    return seen.size();
}

TEST(ParallelFor, HasAsManyThreadsAsWereAskedFor) {
    const unsigned processors = thread_count();
    for (const unsigned threads : {2 * processors + 1, processors, 1U}) {
        const ThreadCount count(threads);
        EXPECT_EQ(thread_count(), threads);
        EXPECT_EQ(threads_at_once(std::size_t{8} * threads, threads), threads);
    }
    EXPECT_EQ(thread_count(), processors) << "the limit has gone";
}

} // namespace
} // namespace ciel::test
