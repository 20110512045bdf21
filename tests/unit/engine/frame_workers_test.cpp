#include "engine/schedule/frame_workers.hpp"

#include <array>
#include <atomic>
#include <gtest/gtest.h>
#include <latch>

namespace server::engine {
using namespace ciel;
namespace {

using namespace std::chrono_literals;

limits::Memory unlimited() {
    return {UINT64_MAX, [] { return std::uint64_t{0}; }, [] {}};
}

struct Order {
    std::mutex mutex;
    std::string letters;
    FrameWorkers::Job note(char letter) {
        return [this, letter](Worker&) {
            const std::scoped_lock lock(mutex);
            letters += letter;
        };
    }
};

// One worker with a job that blocks until let_go(). Jobs posted meanwhile are all queued.
class BusyWorker {
    std::latch started_{1}, go_{1}, done_{1}; // declared before the workers that use them

public:
    BusyWorker() {
        workers.post([this](Worker&) {
            started_.count_down();
            go_.wait();
        });
        started_.wait();
    }
    void let_go_and_wait() {
        go_.count_down();
        done_.wait();
    }
    FrameWorkers::Job last() {
        return [this](Worker&) { done_.count_down(); };
    }
    limits::Memory memory = unlimited();
    FrameWorkers workers{1, render::Backend::automatic, memory};
};

TEST(frame_workers, interactive_jobs_go_before_stills_that_are_due) {
    Order order;
    BusyWorker busy;
    busy.workers.post_later(Clock::now(), order.note('s'));
    busy.workers.post(order.note('a'));
    busy.workers.post(order.note('b'));
    busy.workers.post_later(Clock::now() + 1ms, order.note('t'));
    busy.workers.post_later(Clock::now() + 2ms, busy.last());
    busy.let_go_and_wait();
    EXPECT_EQ(order.letters, "abst");
}

TEST(frame_workers, a_still_that_waits_too_long_goes_first) {
    Order order;
    BusyWorker busy;
    busy.workers.post(order.note('a'));
    busy.workers.post_later(Clock::now() - 2s, order.note('s'));
    busy.workers.post(busy.last());
    busy.let_go_and_wait();
    EXPECT_EQ(order.letters, "sa");
}

TEST(frame_workers, of_many_stills_that_wait_too_long_one_goes_before_the_interactive_jobs) {
    Order order;
    BusyWorker busy;
    for (const char letter : {'s', 't', 'u'}) busy.workers.post_later(Clock::now() - 2s, order.note(letter));
    for (const char letter : {'a', 'b'}) busy.workers.post(order.note(letter));
    busy.workers.post_later(Clock::now() + 1ms, busy.last());
    busy.let_go_and_wait();
    EXPECT_EQ(order.letters, "sabtu");
}

TEST(frame_workers, run_returns_the_result_or_the_exception) {
    limits::Memory memory = unlimited();
    FrameWorkers workers(2, render::Backend::automatic, memory);
    EXPECT_EQ(workers.run([](Worker&) { return 7; }), 7);
    EXPECT_THROW(workers.run([](Worker&) -> int { throw Error("no"); }), Error);
}

TEST(frame_workers, drain_finishes_what_runs_and_refuses_the_rest) {
    limits::Memory memory = unlimited();
    FrameWorkers workers(1, render::Backend::automatic, memory);
    std::atomic<int> finished = 0;
    std::latch started(1);
    workers.post([&](Worker&) {
        started.count_down();
        for (int i = 0; i < 60'000 && workers.post([&](Worker&) { finished += 100; }); ++i)
            std::this_thread::sleep_for(1ms);
        std::this_thread::sleep_for(20ms); // long enough for a drain() that does not wait to return
        ++finished;
    });
    started.wait();
    workers.drain();
    EXPECT_EQ(finished, 1);
    EXPECT_FALSE(workers.post([](Worker&) {}));
    EXPECT_THROW(workers.run([](Worker&) { return 0; }), Error);
}

TEST(frame_workers, go_on_after_a_job_that_throws) {
    limits::Memory memory = unlimited();
    FrameWorkers workers(1, render::Backend::automatic, memory);
    workers.post([](Worker&) { throw std::bad_alloc(); });
    EXPECT_EQ(workers.run([](Worker&) { return 7; }), 7);
    workers.drain();
}

TEST(frame_workers, a_job_for_one_worker_waits_for_that_worker) {
    limits::Memory memory = unlimited();
    std::latch started{1}, go{1}, done{2};
    std::atomic<const Worker*> busy = nullptr;
    std::array<std::atomic<const Worker*>, 2> ran{};
    FrameWorkers workers{2, render::Backend::automatic, memory};
    ASSERT_EQ(workers.count(), 2U);
    workers.post([&](Worker& worker) {
        busy = &worker;
        started.count_down();
        go.wait();
    });
    started.wait();
    for (unsigned number = 0; number < 2; ++number)
        workers.post_later_to(number, Clock::now(), [&, number](Worker& worker) {
            ran[number] = &worker;
            done.count_down();
        });
    while (ran[0] == nullptr && ran[1] == nullptr) std::this_thread::yield();
    std::this_thread::sleep_for(20ms);
    EXPECT_NE(ran[0] == nullptr, ran[1] == nullptr) << "the free worker has run both";
    go.count_down();
    done.wait();
    EXPECT_NE(ran[0], ran[1]);
    EXPECT_TRUE(ran[0] == busy || ran[1] == busy);
}

} // namespace
} // namespace server::engine
