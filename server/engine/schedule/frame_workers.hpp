// Threads that draw frames, each with its own GL context. A context never moves to another thread, and sessions own
// none.
#pragma once

#include "frames/picture.hpp"
#include "limits/memory.hpp"
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

// The resources of a worker thread that its jobs may use.
class Worker {
public:
    Worker(const FrameWorkers& all, render::Backend backend, limits::Memory& memory, int still_samples)
        : all_(all), backend_(backend), still_samples_(still_samples), memory_(memory),
          drawing_(memory, limits::Held::drawing) {}
    // Returns the thread's renderer. It is made at the first call, so that jobs without pictures need no GL. Throws
    // Error when that fails; the next call tries again.
    [[nodiscard]] render::Renderer& renderer();
    [[nodiscard]] const FrameWorkers& all() const { return all_; }     // the pool of this worker
    [[nodiscard]] int still_samples() const { return still_samples_; } // per pixel
    void rest(); // frees the memory that large pictures have taken

private:
    const FrameWorkers& all_;
    render::Backend backend_;
    int still_samples_;
    limits::Memory& memory_;
    limits::Memory::Charge drawing_; // counts the memory that the renderer keeps
    std::optional<render::Renderer> renderer_;
};

// All members of FrameWorkers are thread-safe.
class FrameWorkers {
public:
    using Job = std::function<void(Worker&)>; // must not throw

    // `memory` counts the buffers of the renderers. Does not own it; it must outlive the FrameWorkers.
    FrameWorkers(unsigned threads, render::Backend backend, limits::Memory& memory,
                 int still_samples = frames::default_still_samples);
    ~FrameWorkers(); // waits for running jobs, drops waiting ones

    // Jobs of post() run first, in order. A job of post_later() runs at `due` or later, when no job of post() waits. A
    // job of post_later() that has waited for a second after `due` goes before the jobs of post(). Then all jobs that
    // it passed run before another job may pass. Once drained, both functions drop the job and return false.
    bool post(Job job);
    bool post_later(Clock::time_point due, Job job);

    // Runs `function(worker)` on a worker, after interactive frames, and waits for its result or exception. Must not be
    // called from a job. Throws Error once drained.
    template <class Function>
    auto run(Function function) {
        using Result = decltype(function(std::declval<Worker&>()));
        auto task = std::make_shared<std::packaged_task<Result(Worker&)>>(std::move(function));
        auto result = task->get_future();
        const bool posted = post_later(Clock::now(), [task](Worker& worker) { (*task)(worker); });
        task.reset(); // otherwise get() would wait forever for a dropped job
        try {
            if (posted) return result.get();
        } catch (const std::future_error&) { // the job was dropped
        }
        throw Error("the server is about to stop and draws no further pictures; try again after its restart");
    }

    void rest();                         // makes each worker rest() when it is idle
    void drain();                        // refuses jobs; returns when no job runs
    [[nodiscard]] unsigned busy() const; // workers that run a job
    [[nodiscard]] bool draining() const;
    [[nodiscard]] bool has_waiting() const; // true if a job of post() waits because no worker is free

private:
    void work(const std::stop_token& stop);
    // Waits for a job and returns it; empty when `stop` was requested. An idle worker rests meanwhile if rests_ differs
    // from `rests`, the number of rest() calls that it has followed.
    [[nodiscard]] Job next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, Worker& worker,
                           std::uint64_t& rests);

    render::Backend backend_;
    limits::Memory& memory_;
    int still_samples_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Job> now_;
    std::multimap<Clock::time_point, Job> later_;
    std::size_t passed_over_ = 0; // number of jobs at the front of now_ that a job of later_ went before
    unsigned busy_ = 0;
    bool draining_ = false;
    std::uint64_t rests_ = 0; // number of rest() calls
    std::vector<std::jthread> threads_;
};

} // namespace ciel::engine
