#include "ciel/parallel.hpp"

#include <algorithm>

#if defined(CIEL_PARALLEL_TBB)
#include <memory>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#elif defined(CIEL_PARALLEL_THREADS)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace ciel {

#if defined(CIEL_PARALLEL_TBB)

namespace {
std::unique_ptr<tbb::global_control> limit;
std::unique_ptr<tbb::task_arena> wide_arena; // the default arena has only one slot per processor
} // namespace

void set_thread_count(unsigned threads) {
    wide_arena.reset();
    limit.reset(); // the smallest live limit applies, so destroy the old one first
    if (threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
    if (threads > static_cast<unsigned>(tbb::info::default_concurrency()))
        wide_arena = std::make_unique<tbb::task_arena>(static_cast<int>(threads));
}

unsigned thread_count() {
    return static_cast<unsigned>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallel_for(std::size_t count, std::size_t grain, LoopBody body) {
    if (count == 0) return;
    grain = std::max<std::size_t>(1, grain);
    if (count <= grain) return body(0, count);
    const auto loop = [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, grain),
            [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); },
            tbb::simple_partitioner());
    };
    wide_arena ? wide_arena->execute(loop) : loop();
}

#elif defined(CIEL_PARALLEL_THREADS)

namespace {
std::atomic<unsigned> requested{0};
}

void set_thread_count(unsigned threads) { requested = threads; }

unsigned thread_count() {
    const unsigned threads = requested;
    return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

void parallel_for(std::size_t count, std::size_t grain, LoopBody body) {
    if (count == 0) return;
    grain = std::max<std::size_t>(1, grain);
    const std::size_t ranges = (count + grain - 1) / grain;
    std::atomic<std::size_t> next{0};
    std::exception_ptr first_error;
    std::mutex error_mutex;
    const auto work = [&] {
        for (std::size_t i = next++; i < ranges; i = next++) {
            try {
                body(i * grain, std::min(count, (i + 1) * grain));
            } catch (...) {
                const std::lock_guard lock(error_mutex);
                if (!first_error) first_error = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> helpers;
        const std::size_t threads = std::min<std::size_t>(ranges, thread_count());
        for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
        work();
    }
    if (first_error) std::rethrow_exception(first_error);
}

#else // a serial loop, for WebAssembly and as the reference for TBB and std::thread

void set_thread_count(unsigned) {}

unsigned thread_count() { return 1; }

void parallel_for(std::size_t count, std::size_t grain, LoopBody body) {
    grain = std::max<std::size_t>(1, grain);
    for (std::size_t begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
}

#endif

} // namespace ciel
