// Runs calls that draw, extract or export on separate threads, so that quick calls never wait for them.
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

// SlowCalls is thread-safe. Connections take turns: the calls of a connection with many calls do not delay other
// connections.
class SlowCalls {
public:
    enum class Turn { come, given_up };    // given up: the connection has ended, or the server is about to stop
    using Job = std::function<void(Turn)>; // called exactly once; must not throw

    explicit SlowCalls(const limits::Limits& limits);
    ~SlowCalls(); // calls drain()

    // Queues a job of a connection. Throws LimitReached when too many jobs wait already, Error once drained.
    void post(std::uint64_t connection, Job job);
    // Called from a job: queues the next job of the same request. It is not limited by the number of waiting jobs.
    // Throws Error once drained.
    void post_next(std::uint64_t connection, Job job);
    // Gives up the waiting jobs of a connection: calls them with Turn::given_up on the calling thread.
    void drop(std::uint64_t connection);
    void drain(); // gives up waiting jobs; returns when no job runs

    [[nodiscard]] std::size_t running() const;
    [[nodiscard]] std::size_t waiting() const;

private:
    void work(const std::stop_token& stop);
    void check_open() const; // requires mutex_ to be held, as add, take and count_waiting do
    void add(std::uint64_t connection, Job job);
    [[nodiscard]] Job take();
    [[nodiscard]] std::size_t count_waiting() const;

    const limits::Limits& limits_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::map<std::uint64_t, std::deque<Job>> waiting_; // jobs by connection; no queue is empty
    std::deque<std::uint64_t> turns_;                  // keys of waiting_; the front has the next turn
    std::size_t running_ = 0;
    bool draining_ = false;
    std::vector<std::jthread> threads_;
};

} // namespace ciel::engine
