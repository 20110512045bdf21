#include "engine/schedule/frame_workers.hpp"

#include "engine/schedule/run_job.hpp"
#include "limits/machine_memory.hpp"

#include <algorithm>

namespace server::engine {
namespace {
// A job of post_later() that waits longer than this after it is due runs before jobs of post().
constexpr std::chrono::seconds patience{1};
// rest() frees the memory of a renderer that keeps more bytes than this.
constexpr std::uint64_t worth_giving_back = std::uint64_t{64} << 20;

render::Spare spare(const limits::Memory& memory) {
    const limits::SpareMemory left = limits::spare_memory();
    return {left.memory, left.address_space, memory.room()};
}

} // namespace

render::Renderer& Worker::renderer() {
    if (!renderer_)
        renderer_.emplace(
            backend_, [this] { return spare(memory_); }, [this](std::uint64_t bytes) { drawing_.note(bytes); });
    return *renderer_;
}

void Worker::rest() {
    if (renderer_ && renderer_->kept_memory() > worth_giving_back) renderer_->give_back_memory();
}

FrameWorkers::FrameWorkers(unsigned threads, render::Backend backend, limits::Memory& memory, int still_samples)
    : backend_(backend), memory_(memory), still_samples_(still_samples) {
    for (unsigned i = 0; i < std::max(threads, 1U); ++i)
        threads_.emplace_back([this, i](const std::stop_token& stop) { work(stop, i); });
}

FrameWorkers::~FrameWorkers() {
    drain();
    for (auto& thread : threads_) thread.request_stop();
}

bool FrameWorkers::post(Job job) {
    const std::scoped_lock lock(mutex_);
    if (draining_) return false;
    now_.push_back(std::move(job));
    changed_.notify_all();
    return true;
}

bool FrameWorkers::post_later(Clock::time_point due, Job job) { return add_later(due, {std::move(job), {}}); }

bool FrameWorkers::post_later_to(unsigned number, Clock::time_point due, Job job) {
    return add_later(due, {std::move(job), number});
}

bool FrameWorkers::add_later(Clock::time_point due, LaterJob job) {
    const std::scoped_lock lock(mutex_);
    if (draining_) return false;
    later_.emplace(due, std::move(job));
    changed_.notify_all();
    return true;
}

unsigned FrameWorkers::count() const { return static_cast<unsigned>(threads_.size()); }

void FrameWorkers::rest() {
    const std::scoped_lock lock(mutex_);
    ++rests_;
    changed_.notify_all();
}

void FrameWorkers::drain() {
    std::deque<Job> dropped_now; // destroyed after `lock`, because a job may hold the last reference to a view
    LaterJobs dropped_later;
    std::unique_lock lock(mutex_);
    draining_ = true;
    dropped_now.swap(now_);
    dropped_later.swap(later_);
    changed_.wait(lock, [&] { return busy_ == 0; });
}

unsigned FrameWorkers::busy() const {
    const std::scoped_lock lock(mutex_);
    return busy_;
}

bool FrameWorkers::draining() const {
    const std::scoped_lock lock(mutex_);
    return draining_;
}

bool FrameWorkers::has_waiting() const {
    const std::scoped_lock lock(mutex_);
    return busy_ == threads_.size() && !now_.empty();
}

FrameWorkers::LaterJobs::iterator FrameWorkers::later_for(unsigned number) {
    return std::ranges::find_if(later_,
                                [number](const auto& later) { return later.second.only.value_or(number) == number; });
}

FrameWorkers::Job FrameWorkers::next(std::unique_lock<std::mutex>& lock, const std::stop_token& stop, unsigned number,
                                     Worker& worker, std::uint64_t& rests) {
    const auto take = [&](LaterJobs::iterator later) {
        Job job = std::move(later->second.job);
        later_.erase(later);
        return job;
    };
    constexpr Clock::time_point never = Clock::time_point::max();
    const auto due_of = [&](LaterJobs::iterator later) { return later == later_.end() ? never : later->first; };
    while (!stop.stop_requested()) {
        const auto time = Clock::now();
        const auto later = later_for(number);
        if (passed_over_ == 0 && later != later_.end() && later->first + patience < time) {
            passed_over_ = now_.size();
            return take(later);
        }
        if (!now_.empty()) {
            Job job = std::move(now_.front());
            now_.pop_front();
            if (passed_over_ > 0) --passed_over_;
            return job;
        }
        if (later != later_.end() && later->first <= time) return take(later);
        if (rests != rests_) {
            rests = rests_;
            lock.unlock();
            worker.rest();
            lock.lock();
            continue;
        }
        const auto due = due_of(later);
        const auto has_other = [&] { return !now_.empty() || rests != rests_ || due_of(later_for(number)) != due; };
        if (due == never)
            changed_.wait(lock, stop, has_other);
        else
            changed_.wait_until(lock, stop, due, has_other);
    }
    return {};
}

void FrameWorkers::work(const std::stop_token& stop, unsigned number) {
    Worker worker(*this, backend_, memory_, still_samples_);
    std::unique_lock lock(mutex_);
    std::uint64_t rests = rests_;
    while (Job job = next(lock, stop, number, worker, rests)) {
        ++busy_;
        lock.unlock();
        run_job([&] { job(worker); });
        job = nullptr; // destroys the objects of the job before the lock is taken
        lock.lock();
        --busy_;
        rests = rests_; // ignores rest() calls during the job, because the worker has just drawn
        changed_.notify_all();
    }
}

} // namespace server::engine
