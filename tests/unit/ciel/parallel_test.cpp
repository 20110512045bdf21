// Number of threads that the kernel's parallel loop uses.
#include "ciel/parallel.hpp"
#include "ciel/types.hpp"
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
// patience: ends the wait when the loop uses fewer threads than wanted.
std::size_t threads_at_once(std::size_t tasks, std::size_t wanted,
                            std::chrono::milliseconds patience = std::chrono::seconds(20)) {
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

TEST(WithThreads, LimitsTheLoopsOfOneCall) {
    const ThreadCount six(6);
    for (const unsigned threads : {1U, 2U, 4U}) {
        std::size_t most = 0;
        with_threads(threads, [&] {
            EXPECT_EQ(thread_count(), threads);
            EXPECT_EQ(threads_at_once(48, threads), threads);
            // One thread more is awaited in vain.
            most = threads_at_once(8, threads + 1, std::chrono::milliseconds(50));
        });
        EXPECT_EQ(most, threads);
        EXPECT_EQ(thread_count(), 6U) << "the limit has gone";
    }
    with_threads(0, [] { EXPECT_EQ(thread_count(), 6U) << "no limit"; });
    with_threads(99, [] { EXPECT_EQ(thread_count(), 6U) << "a call never has more threads than the process"; });
}

TEST(WithThreads, LimitsLoopsInsideLoops) {
    const ThreadCount six(6);
    std::mutex mutex;
    std::set<std::thread::id> seen;
    with_threads(2, [&] {
        parallel_for(6, 1, [&](std::size_t, std::size_t) {
            with_threads(4, [&] {
                parallel_for(6, 1, [&](std::size_t, std::size_t) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(2)); // time for another thread to come
                    const std::lock_guard lock(mutex);
                    seen.insert(std::this_thread::get_id());
                });
            });
        });
    });
    EXPECT_LE(seen.size(), 2U);
}

TEST(WithThreads, PassesExceptionsOnAndForgetsTheLimit) {
    const ThreadCount six(6);
    for (const unsigned threads : {1U, 3U}) {
        const auto failing = [&] {
            with_threads(threads, [] {
                parallel_for(9, 1, [](std::size_t begin, std::size_t) {
                    if (begin == 4) throw Error("the fifth task fails");
                });
            });
        };
        EXPECT_THROW(failing(), Error);
        EXPECT_EQ(thread_count(), 6U);
    }
}

} // namespace
} // namespace ciel::test
