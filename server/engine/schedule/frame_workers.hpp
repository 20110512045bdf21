// Threads that draw frames. Each thread has its own GL context, which never moves to another thread.
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

namespace server::engine {

using Clock = std::chrono::steady_clock;

class FrameWorkers;

class Worker {
public:
    Worker(const FrameWorkers& all, render::Backend backend, limits::Memory& memory, int still_samples)
        : all_(all), backend_(backend), still_samples_(still_samples), memory_(memory),
          drawing_(memory, limits::Held::drawing) {}
    // The first call makes the renderer, because some jobs need no GL. After an Error, a later call tries again.
    [[nodiscard]] render::Renderer& renderer();
    [[nodiscard]] const FrameWorkers& all() const { return all_; }
    [[nodiscard]] int still_samples() const { return still_samples_; } // per pixel
    void rest(); // frees memory that the renderer keeps after large pictures

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

    // `memory` counts the buffers of the renderers. It is not owned and must outlive the FrameWorkers.
    FrameWorkers(unsigned threads, render::Backend backend, limits::Memory& memory,
                 int still_samples = frames::default_still_samples);
    ~FrameWorkers(); // waits for running jobs; drops waiting jobs

    // Jobs of post() run first, in order. A job of post_later() runs at `due` or later, when no job of post() waits.
    // One second after `due`, the job overtakes the waiting jobs of post(). The next job of post_later() may overtake
    // only after all these jobs have begun. After drain(), the functions drop the job and return false.
    bool post(Job job);
    bool post_later(Clock::time_point due, Job job);
    bool post_later_to(unsigned number, Clock::time_point due, Job job); // to one worker. REQUIRES: number < count()

    // Runs `function(worker)` after interactive frames. Waits for its end, and returns its result or throws its
    // exception. Must not be called from a job. Throws Error after drain().
    template <class Function>
    auto run(Function function) {
        using Result = decltype(function(std::declval<Worker&>()));
        auto task = std::make_shared<std::packaged_task<Result(Worker&)>>(std::move(function));
        auto result = task->get_future();
        const bool posted = post_later(Clock::now(), [task](Worker& worker) { (*task)(worker); });
        task.reset(); // otherwise get() would wait forever if the job is dropped
        try {
            if (posted) return result.get();
        } catch (const std::future_error&) { // the job was dropped
        }
        throw ciel::Error("the server is about to stop and draws no further pictures; try again after its restart");
    }

    void rest();                          // makes each worker call its rest() when it is idle
    [[nodiscard]] unsigned count() const; // number of workers
    void drain();                         // drops waiting jobs, refuses new jobs; returns when no job runs
    [[nodiscard]] unsigned busy() const;  // number of workers that run a job
    [[nodiscard]] bool draining() const;
    [[nodiscard]] bool has_waiting() const; // true if a job of post() waits because no worker is free

private:
    struct LaterJob {
        Job job;
        std::optional<unsigned> only; // number of the worker that must run it; nullopt: any worker
    };
    using LaterJobs = std::multimap<Clock::time_point, LaterJob>;

    bool add_later(Clock::time_point due, LaterJob job);
    void work(const std::stop_token& stop, unsigned number);
    // Returns the first job of later_ that the worker may run, or the end.
    [[nodiscard]] LaterJobs::iterator later_for(unsigned number);
    // Returns an empty job if `stop` was requested. `rests`: number of rest() calls that this worker has followed.
    [[nodiscard]] Job next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, unsigned number,
                           Worker& worker, std::uint64_t& rests);

    render::Backend backend_;
    limits::Memory& memory_;
    int still_samples_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Job> now_;
    LaterJobs later_;
    std::size_t passed_over_ = 0; // number of jobs at the front of now_ that a job of later_ has overtaken
    unsigned busy_ = 0;
    bool draining_ = false;
    std::uint64_t rests_ = 0; // number of rest() calls
    std::vector<std::jthread> threads_;
};

} // namespace server::engine
