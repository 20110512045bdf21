// Threads that draw, each with a GL context of its own: contexts never move, sessions own none.
#pragma once

#include "frames/still_samples.hpp"
#include "render/renderer.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace ciel::engine {

using Clock = std::chrono::steady_clock;

class FrameWorkers;

// What a job gets of the thread that it runs on.
class Worker {
public:
    Worker(const FrameWorkers& all, render::Backend backend, int still_samples)
        : all_(all), backend_(backend), still_samples_(still_samples) {}
    // Made at first use, so that work without pictures needs no GL. Throws Error; the next call tries again.
    [[nodiscard]] render::Renderer& renderer();
    [[nodiscard]] const FrameWorkers& all() const { return all_; }     // of which this is one
    [[nodiscard]] int still_samples() const { return still_samples_; } // of a pixel
    void rest();                                                       // gives back what large pictures have taken

private:
    const FrameWorkers& all_;
    render::Backend backend_;
    int still_samples_;
    std::optional<render::Renderer> renderer_;
};

// Thread-safe.
class FrameWorkers {
public:
    using Job = std::function<void(Worker&)>; // must not throw

    FrameWorkers(unsigned threads, render::Backend backend, int still_samples = frames::default_still_samples);
    ~FrameWorkers(); // waits for the jobs under way, drops the rest

    // Jobs of post go first, in order. A job of post_later starts at `due` or after, when no other waits. After a
    // second of waiting it goes before the jobs of post, which then all go before the next such one. Dropped, with
    // false, once drained.
    bool post(Job job);
    bool post_later(Clock::time_point due, Job job);

    // Runs `function(worker)` on a worker, after interactive frames, and waits for its result or exception. Not to be
    // called from a job.
    template <class Function>
    auto run(Function function) {
        using Result = decltype(function(std::declval<Worker&>()));
        auto task = std::make_shared<std::packaged_task<Result(Worker&)>>(std::move(function));
        auto result = task->get_future();
        const bool posted = post_later(Clock::now(), [task](Worker& worker) { (*task)(worker); });
        task.reset(); // else a dropped job would leave the wait below without end
        try {
            if (posted) return result.get();
        } catch (const std::future_error&) { // dropped
        }
        throw Error("the server is about to stop and draws no more");
    }

    void rest();                         // each worker does, as soon as it has nothing to do
    void drain();                        // no new jobs; returns when those under way have ended
    [[nodiscard]] unsigned busy() const; // workers with a job under way
    [[nodiscard]] bool draining() const;
    [[nodiscard]] bool has_waiting() const; // a job of post() for which no worker was free

private:
    void work(const std::stop_token& stop);
    // Rests meanwhile: `rests` counts those that this worker knows of.
    [[nodiscard]] Job next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, Worker& worker,
                           std::uint64_t& rests);

    render::Backend backend_;
    int still_samples_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Job> now_;
    std::multimap<Clock::time_point, Job> later_;
    std::size_t passed_over_ = 0; // jobs of now_, the first ones, that one of later_ went before
    unsigned busy_ = 0;
    bool draining_ = false;
    std::uint64_t rests_ = 0; // that were asked for
    std::vector<std::jthread> threads_;
};

} // namespace ciel::engine
