// Calls that draw, extract or export: on threads of their own, so that nothing quick ever waits behind them.
#pragma once

#include "limits/limits.hpp"

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace ciel::engine {

// Thread-safe. Connections take turns: who has many calls waits longer, not the others.
class SlowCalls {
public:
    enum class Turn { come, given_up };    // given up: the connection has ended, or the server is about to stop
    using Job = std::function<void(Turn)>; // called exactly once; must not throw

    explicit SlowCalls(const limits::Limits& limits);
    ~SlowCalls(); // drains

    // Throws LimitReached when too many wait already, Error once drained.
    void post(std::uint64_t connection, Job job);
    // From a job: the next one of the same request. It has its place already, so that only draining refuses it.
    void post_next(std::uint64_t connection, Job job);
    // What waits for this connection is given up, on the calling thread.
    void drop(std::uint64_t connection);
    void drain(); // gives up what waits; returns when what runs has ended

    [[nodiscard]] std::size_t running() const;
    [[nodiscard]] std::size_t waiting() const;

private:
    void work(const std::stop_token& stop);
    void check_open() const; // REQUIRES: the lock, as the next three do
    void add(std::uint64_t connection, Job job);
    [[nodiscard]] Job take();
    [[nodiscard]] std::size_t count_waiting() const;

    const limits::Limits& limits_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::map<std::uint64_t, std::deque<Job>> waiting_; // by connection, none of them empty
    std::deque<std::uint64_t> turns_;                  // the keys of `waiting_`, the next one first
    std::size_t running_ = 0;
    bool draining_ = false;
    std::vector<std::jthread> threads_;
};

} // namespace ciel::engine
