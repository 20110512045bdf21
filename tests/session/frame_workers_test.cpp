#include "session/frame_workers.hpp"

#include <atomic>
#include <gtest/gtest.h>
#include <latch>

namespace ciel::session {
namespace {

using namespace std::chrono_literals;

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

TEST(frame_workers, interactive_jobs_go_before_stills_that_are_due) {
    FrameWorkers workers(1, render::Backend::automatic);
    Order order;
    std::latch started(1), go(1), done(1);
    workers.post([&](Worker&) {
        started.count_down();
        go.wait();
    });
    started.wait(); // the worker is busy: all that follows waits together
    workers.post_later(Clock::now(), order.note('s'));
    workers.post(order.note('a'));
    workers.post(order.note('b'));
    workers.post_later(Clock::now() + 1ms, order.note('t'));
    workers.post_later(Clock::now() + 2ms, [&](Worker&) { done.count_down(); });
    go.count_down();
    done.wait();
    EXPECT_EQ(order.letters, "abst");
}

TEST(frame_workers, a_still_that_waits_too_long_goes_first) {
    FrameWorkers workers(1, render::Backend::automatic);
    Order order;
    std::latch started(1), go(1), done(1);
    workers.post([&](Worker&) {
        started.count_down();
        go.wait();
    });
    started.wait();
    workers.post(order.note('a'));
    workers.post_later(Clock::now() - 2s, order.note('s'));
    workers.post([&](Worker&) { done.count_down(); });
    go.count_down();
    done.wait();
    EXPECT_EQ(order.letters, "sa");
}

TEST(frame_workers, run_returns_the_result_or_the_exception) {
    FrameWorkers workers(2, render::Backend::automatic);
    EXPECT_EQ(workers.run([](Worker&) { return 7; }), 7);
    EXPECT_THROW(workers.run([](Worker&) -> int { throw Error("no"); }), Error);
}

TEST(frame_workers, drain_finishes_what_runs_and_refuses_the_rest) {
    FrameWorkers workers(1, render::Backend::automatic);
    std::atomic<int> finished = 0;
    std::latch started(1);
    workers.post([&](Worker&) {
        started.count_down();
        std::this_thread::sleep_for(20ms);
        ++finished;
    });
    started.wait();
    workers.post([&](Worker&) { finished += 100; });
    workers.drain();
    EXPECT_EQ(finished, 1);
    EXPECT_FALSE(workers.post([](Worker&) {}));
    EXPECT_THROW(workers.run([](Worker&) { return 0; }), Error);
}

} // namespace
} // namespace ciel::session
