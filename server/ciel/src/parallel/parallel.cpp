#include "ciel/process_threads.hpp"

#include <algorithm>
#include <utility>

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

#if !defined(CIEL_PARALLEL_SERIAL)

namespace {

thread_local unsigned limit_of_call = 0; // for loops that this thread starts; 0: the limit of the process

class CallLimit {
public:
    explicit CallLimit(unsigned threads) : before_(std::exchange(limit_of_call, threads)) {}
    ~CallLimit() { limit_of_call = before_; }
    CallLimit(const CallLimit&) = delete;
    CallLimit& operator=(const CallLimit&) = delete;

private:
    unsigned before_;
};

void run_in_turn(std::size_t count, std::size_t grain, LoopBody body) {
    for (std::size_t begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
}

[[nodiscard]] unsigned process_thread_count();
void run_on_threads(std::size_t count, std::size_t grain, LoopBody body); // REQUIRES: count > grain > 0

} // namespace

unsigned thread_count() {
    const unsigned all = process_thread_count();
    return limit_of_call > 0 ? std::min(limit_of_call, all) : all;
}

void parallel_for(std::size_t count, std::size_t grain, LoopBody body) {
    if (count == 0) return;
    grain = std::max<std::size_t>(1, grain);
    if (count <= grain) return body(0, count);
    if (limit_of_call == 0) return run_on_threads(count, grain, body);
    if (limit_of_call == 1) return run_in_turn(count, grain, body);
    // Loops that several bodies start must not exceed the limit together, so each runs on the thread of its body only.
    run_on_threads(count, grain, [&](std::size_t begin, std::size_t end) {
        const CallLimit alone(1);
        body(begin, end);
    });
}

#endif

#if defined(CIEL_PARALLEL_TBB)

namespace {
std::unique_ptr<tbb::global_control> limit;
// Set if there are more threads than processors, because the default arena has only one slot for each processor.
std::unique_ptr<tbb::task_arena> wide_arena;
} // namespace

void set_thread_count(unsigned threads) {
    wide_arena.reset();
    limit.reset(); // the smallest existing limit applies, so remove the old limit first
    if (threads > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
    if (threads > static_cast<unsigned>(tbb::info::default_concurrency()))
        wide_arena = std::make_unique<tbb::task_arena>(static_cast<int>(threads));
}

void run_with_threads(unsigned threads, const std::function<void()>& call) {
    const unsigned allowed = std::min(threads, thread_count());
    const auto limited = [&] {
        const CallLimit call_limit(allowed);
        call();
    };
    if (allowed == 1 || allowed == limit_of_call) return limited();
    tbb::task_arena(static_cast<int>(allowed)).execute(limited);
}

namespace {

unsigned process_thread_count() {
    return static_cast<unsigned>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void run_on_threads(std::size_t count, std::size_t grain, LoopBody body) {
    const auto loop = [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, grain),
            [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); },
            tbb::simple_partitioner());
    };
    wide_arena&& limit_of_call == 0 ? wide_arena->execute(loop) : loop(); // a limited call has an arena already
}

} // namespace

#elif defined(CIEL_PARALLEL_THREADS)

namespace {
std::atomic<unsigned> requested{0};
}

void set_thread_count(unsigned threads) { requested = threads; }

void run_with_threads(unsigned threads, const std::function<void()>& call) {
    const CallLimit call_limit(std::min(threads, thread_count()));
    call();
}

namespace {

unsigned process_thread_count() {
    const unsigned threads = requested;
    return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

void run_on_threads(std::size_t count, std::size_t grain, LoopBody body) {
    const std::size_t ranges = (count + grain - 1) / grain;
    std::atomic<std::size_t> next{0};
    std::exception_ptr first_error;
    std::mutex error_mutex;
    const auto work = [&] {
        for (std::size_t i = next++; i < ranges; i = next++) {
            try {
                body(i * grain, std::min(count, (i + 1) * grain));
            } catch (...) {
                next = ranges; // ranges that have not begun are skipped, as with TBB
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

} // namespace

#else // a serial loop, for WebAssembly and as the reference for TBB and std::thread

void set_thread_count(unsigned) {}

unsigned thread_count() { return 1; }

void run_with_threads(unsigned, const std::function<void()>& call) { call(); }

void parallel_for(std::size_t count, std::size_t grain, LoopBody body) {
    grain = std::max<std::size_t>(1, grain);
    for (std::size_t begin = 0; begin < count; begin += grain) body(begin, std::min(count, begin + grain));
}

#endif

} // namespace ciel
