// Runs slow calls, which draw, extract or export, on separate threads, so that quick calls never wait for slow calls.
#pragma once

#include "limits/limits.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace server::engine {

// Thread-safe. Connections take turns, so that a connection with many calls does not delay the others.
class SlowCallQueue {
public:
    // cancelled: the job must not run, because its connection has ended or the server is about to stop.
    enum class Outcome { run, cancelled };
    using Job = std::function<void(Outcome)>; // called exactly once; must not throw

    explicit SlowCallQueue(const limits::Limits& limits);
    ~SlowCallQueue(); // calls drain()

    // Queues a job of a connection. Throws LimitReached if too many jobs wait already, and Error after drain().
    void post(std::uint64_t connection, Job job);
    // Queues the next job of a request without the limits on waiting jobs. Throws Error after drain().
    void post_next(std::uint64_t connection, Job job);
    // Queues the job when the pause has passed, also without limits. Use it for a call that waits for something, so
    // that it does not keep a thread. Throws Error after drain().
    void post_after(std::chrono::milliseconds pause, std::uint64_t connection, Job job);
    // Returns the pause of a call that was run `tries` times and still waits.
    [[nodiscard]] static std::chrono::milliseconds pause_after(unsigned tries);
    // Calls the waiting jobs of a connection with Outcome::cancelled on the calling thread.
    void drop(std::uint64_t connection);
    // Calls all waiting jobs with Outcome::cancelled, and refuses new jobs. Returns when no job runs.
    void drain();

    [[nodiscard]] std::size_t running() const;
    [[nodiscard]] std::size_t waiting() const;

private:
    using Clock = std::chrono::steady_clock;
    struct Paused {
        std::uint64_t connection;
        Job job;
    };
    void work(const std::stop_token& stop);
    // Returns false when a stop is requested.
    [[nodiscard]] bool wait_for_job(std::unique_lock<std::mutex>& lock, const std::stop_token& stop);
    // The following functions require mutex_ to be held.
    void check_open() const;
    void add(std::uint64_t connection, Job job);
    [[nodiscard]] Job take();
    void resume_paused();
    [[nodiscard]] std::size_t count_waiting() const;
    [[nodiscard]] std::size_t count_waiting(std::uint64_t connection) const;

    const limits::Limits& limits_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::map<std::uint64_t, std::deque<Job>> waiting_; // jobs by connection; no queue is empty
    std::multimap<Clock::time_point, Paused> paused_;  // by the end of the pause
    std::deque<std::uint64_t> turns_;                  // keys of waiting_; the front has the next turn
    std::size_t running_ = 0;
    bool draining_ = false;
    std::vector<std::jthread> threads_;
};

} // namespace server::engine
