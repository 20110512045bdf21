#include "engine/schedule/slow_call_queue.hpp"

#include "limits/errors.hpp"

#include <gmock/gmock.h>
#include <latch>
#include <optional>

namespace server::engine {
using namespace ciel;
namespace {

using testing::HasSubstr;

// One running call that blocks until let_go(). Calls posted meanwhile are all queued.
class BusyCalls {
    std::latch started_{1}, go_{1};
    std::mutex mutex_;
    limits::Limits limits_;
    std::optional<engine::SlowCallQueue> calls_; // declared last, because its threads use the other members

public:
    std::string order; // letters of the calls in the order they ended; a star precedes a cancelled one

    explicit BusyCalls(limits::Limits limits = {}) : limits_(limits) {
        limits_.slow_calls = 1;
        calls_.emplace(limits_);
        calls_->post(0, [this](SlowCallQueue::Outcome) {
            started_.count_down();
            go_.wait();
        });
        started_.wait();
    }
    ~BusyCalls() {
        let_go();
        calls_.reset();
    }
    SlowCallQueue& operator*() { return *calls_; }
    SlowCallQueue* operator->() { return &*calls_; }
    void post(std::uint64_t connection, char letter) { calls_->post(connection, note(letter)); }
    SlowCallQueue::Job note(char letter) {
        return [this, letter](SlowCallQueue::Outcome outcome) {
            const std::scoped_lock lock(mutex_);
            if (outcome == SlowCallQueue::Outcome::cancelled) order += '*';
            order += letter;
        };
    }
    void let_go() {
        if (!go_.try_wait()) go_.count_down();
    }
    void let_go_and_wait() {
        let_go();
        while (calls_->waiting() + calls_->running() > 0) std::this_thread::yield();
    }
};

std::string refusal(BusyCalls& calls, std::uint64_t connection) {
    try {
        calls.post(connection, 'x');
        return "";
    } catch (const limits::LimitReached& limit) {
        return limit.what();
    }
}

TEST(slow_calls, connections_take_turns) {
    BusyCalls calls;
    for (const char letter : {'a', 'b', 'c'}) calls.post(1, letter);
    calls.post(2, 'd');
    calls.post(3, 'e');
    calls.post(2, 'f');
    EXPECT_EQ(calls->running(), 1U);
    EXPECT_EQ(calls->waiting(), 6U);
    calls.let_go_and_wait();
    EXPECT_EQ(calls.order, "adebfc") << "one each before the second of any";
}

TEST(slow_calls, beyond_the_limit_of_all_they_are_refused) {
    limits::Limits limits;
    limits.slow_calls_waiting = 2;
    BusyCalls calls(limits);
    EXPECT_EQ(refusal(calls, 1), "");
    EXPECT_EQ(refusal(calls, 2), "");
    EXPECT_THAT(refusal(calls, 3), HasSubstr("2 slow calls (pictures, exports) already wait on the server; try again"));
    calls->drop(1);
    EXPECT_EQ(refusal(calls, 3), "") << "what was given up makes room";
}

TEST(slow_calls, beyond_the_limit_of_one_connection_they_are_refused) {
    limits::Limits limits;
    limits.slow_calls_of_connection = 2;
    BusyCalls calls(limits);
    EXPECT_EQ(refusal(calls, 1), "");
    EXPECT_EQ(refusal(calls, 1), "");
    EXPECT_THAT(refusal(calls, 1), HasSubstr("2 slow calls (pictures, exports) of this connection already wait"));
    EXPECT_EQ(refusal(calls, 2), "") << "others are none the worse";
}

TEST(slow_calls, the_next_of_a_batch_has_its_place) {
    limits::Limits limits;
    limits.slow_calls_waiting = 1;
    BusyCalls calls(limits);
    calls.post(1, 'a');
    EXPECT_NO_THROW(calls->post_next(1, calls.note('b')));
}

TEST(slow_calls, what_an_ended_connection_waits_for_is_given_up_at_once) {
    BusyCalls calls;
    calls.post(1, 'a');
    calls.post(2, 'b');
    calls.post(1, 'c');
    calls->drop(1);
    EXPECT_EQ(calls.order, "*a*c");
    EXPECT_EQ(calls->waiting(), 1U);
    calls->drop(7);
    calls.let_go_and_wait();
    EXPECT_EQ(calls.order, "*a*cb");
}

TEST(slow_calls, drain_gives_up_what_waits_and_finishes_what_runs) {
    BusyCalls calls;
    calls.post(1, 'a');
    std::jthread draining([&] { calls->drain(); });
    while (calls->waiting() > 0) std::this_thread::yield();
    EXPECT_EQ(calls->running(), 1U);
    calls.let_go();
    draining.join();
    EXPECT_EQ(calls->running(), 0U);
    EXPECT_EQ(calls.order, "*a");
    EXPECT_THROW(calls.post(1, 'b'), Error);
    EXPECT_THROW(calls->post_next(1, calls.note('b')), Error);
}

TEST(slow_calls, a_call_that_waits_keeps_no_thread) {
    limits::Limits limits;
    limits.slow_calls = 1;
    std::latch done(1);
    std::atomic<bool> ran = false;
    std::string cancelled;
    const auto at_the_end = [&](SlowCallQueue::Outcome outcome) {
        EXPECT_EQ(outcome, SlowCallQueue::Outcome::cancelled);
    };
    SlowCallQueue calls(limits);
    calls.post(1, [&](SlowCallQueue::Outcome) {
        calls.post_after(std::chrono::hours(1), 1, at_the_end);
        calls.post_after(std::chrono::milliseconds(1), 1, [&](SlowCallQueue::Outcome) {
            EXPECT_TRUE(ran);
            done.count_down();
        });
        calls.post(2, [&](SlowCallQueue::Outcome) { ran = true; });
    });
    done.wait();
    EXPECT_EQ(calls.waiting(), 1U);
    limits.slow_calls_of_connection = 1;
    EXPECT_THROW(calls.post(1, at_the_end), limits::LimitReached) << "it counts as waiting";
    calls.post_after(std::chrono::hours(1), 4, [&](SlowCallQueue::Outcome outcome) {
        cancelled += outcome == SlowCallQueue::Outcome::cancelled ? "4" : "?";
    });
    calls.drop(4);
    EXPECT_EQ(cancelled, "4");
}

TEST(slow_calls, pauses_grow_to_two_seconds) {
    using std::chrono::milliseconds;
    EXPECT_EQ(SlowCallQueue::pause_after(1), milliseconds(200));
    EXPECT_EQ(SlowCallQueue::pause_after(2), milliseconds(400));
    EXPECT_EQ(SlowCallQueue::pause_after(4), milliseconds(1600));
    EXPECT_EQ(SlowCallQueue::pause_after(5), milliseconds(2000));
    EXPECT_EQ(SlowCallQueue::pause_after(1000), milliseconds(2000));
}

TEST(slow_calls, go_on_after_a_job_that_throws) {
    limits::Limits limits;
    limits.slow_calls = 1;
    SlowCallQueue calls(limits);
    std::latch done(1);
    calls.post(1, [](SlowCallQueue::Outcome) { throw std::bad_alloc(); });
    calls.post(1, [&](SlowCallQueue::Outcome) { done.count_down(); });
    done.wait();
    calls.drain();
    EXPECT_EQ(calls.running(), 0U);
}

} // namespace
} // namespace server::engine
