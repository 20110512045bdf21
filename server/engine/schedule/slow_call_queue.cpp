#include "engine/schedule/slow_call_queue.hpp"

#include "engine/schedule/run_job.hpp"
#include "limits/errors.hpp"

#include <algorithm>
#include <string>

namespace server::engine {

SlowCallQueue::SlowCallQueue(const limits::Limits& limits) : limits_(limits) {
    for (std::uint64_t i = 0; i < limits.slow_calls; ++i)
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
}

SlowCallQueue::~SlowCallQueue() {
    drain();
    for (auto& thread : threads_) thread.request_stop();
}

void SlowCallQueue::post(std::uint64_t connection, Job job) {
    const std::scoped_lock lock(mutex_);
    check_open();
    if (count_waiting() >= limits_.slow_calls_waiting)
        throw limits::LimitReached(
            std::to_string(limits_.slow_calls_waiting) +
            " slow calls (pictures, exports) already wait on the server; try again in a few seconds");
    if (count_waiting(connection) >= limits_.slow_calls_of_connection)
        throw limits::LimitReached(std::to_string(limits_.slow_calls_of_connection) +
                                   " slow calls (pictures, exports) of this connection already wait; try again when "
                                   "one of them has its answer");
    add(connection, std::move(job));
}

void SlowCallQueue::post_next(std::uint64_t connection, Job job) {
    const std::scoped_lock lock(mutex_);
    check_open();
    add(connection, std::move(job));
}

void SlowCallQueue::post_after(std::chrono::milliseconds pause, std::uint64_t connection, Job job) {
    const std::scoped_lock lock(mutex_);
    check_open();
    paused_.emplace(Clock::now() + pause, Paused{connection, std::move(job)});
    changed_.notify_all();
}

std::chrono::milliseconds SlowCallQueue::pause_after(unsigned tries) {
    constexpr std::chrono::milliseconds first{200}, longest{2000};
    constexpr unsigned doublings = 4; // enough to reach the longest pause
    return std::min(first * (1 << std::min(std::max(tries, 1U) - 1, doublings)), longest);
}

void SlowCallQueue::check_open() const {
    if (draining_)
        throw ciel::Error(
            "the server is about to stop and makes no further pictures and exports; try again after its restart");
}

void SlowCallQueue::add(std::uint64_t connection, Job job) {
    auto& jobs = waiting_[connection];
    if (jobs.empty()) turns_.push_back(connection);
    jobs.push_back(std::move(job));
    changed_.notify_all();
}

SlowCallQueue::Job SlowCallQueue::take() {
    const std::uint64_t connection = turns_.front();
    turns_.pop_front();
    const auto of = waiting_.find(connection);
    Job job = std::move(of->second.front());
    of->second.pop_front();
    if (of->second.empty())
        waiting_.erase(of);
    else
        turns_.push_back(connection);
    return job;
}

void SlowCallQueue::drop(std::uint64_t connection) {
    std::deque<Job> dropped;
    {
        const std::scoped_lock lock(mutex_);
        if (const auto of = waiting_.find(connection); of != waiting_.end()) {
            dropped = std::move(of->second);
            waiting_.erase(of);
            std::erase(turns_, connection);
        }
        for (auto& [due, paused] : paused_)
            if (paused.connection == connection) dropped.push_back(std::move(paused.job));
        std::erase_if(paused_, [&](const auto& entry) { return entry.second.connection == connection; });
    }
    for (const Job& job : dropped) job(Outcome::cancelled);
}

void SlowCallQueue::drain() {
    std::map<std::uint64_t, std::deque<Job>> dropped;
    {
        const std::scoped_lock lock(mutex_);
        draining_ = true;
        dropped.swap(waiting_);
        for (auto& [due, paused] : paused_) dropped[paused.connection].push_back(std::move(paused.job));
        paused_.clear();
        turns_.clear();
    }
    for (const auto& [connection, jobs] : dropped)
        for (const Job& job : jobs) job(Outcome::cancelled);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return running_ == 0; });
}

void SlowCallQueue::resume_paused() {
    while (!paused_.empty() && paused_.begin()->first <= Clock::now()) {
        Paused paused = std::move(paused_.begin()->second);
        paused_.erase(paused_.begin());
        add(paused.connection, std::move(paused.job));
    }
}

bool SlowCallQueue::wait_for_job(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        resume_paused();
        if (!turns_.empty()) return true;
        if (paused_.empty()) {
            changed_.wait(lock, stop, [&] { return !turns_.empty() || !paused_.empty(); });
            continue;
        }
        const Clock::time_point due = paused_.begin()->first;
        changed_.wait_until(lock, stop, due,
                            [&] { return !turns_.empty() || paused_.empty() || paused_.begin()->first < due; });
    }
    return false;
}

void SlowCallQueue::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (wait_for_job(lock, stop)) {
        Job job = take();
        ++running_;
        lock.unlock();
        run_job([&] { job(Outcome::run); });
        job = nullptr; // destroys the objects of the job before the lock is taken
        lock.lock();
        --running_;
        changed_.notify_all();
    }
}

std::size_t SlowCallQueue::count_waiting() const {
    std::size_t count = paused_.size();
    for (const auto& [connection, jobs] : waiting_) count += jobs.size();
    return count;
}

std::size_t SlowCallQueue::count_waiting(std::uint64_t connection) const {
    const auto own = waiting_.find(connection);
    const auto paused =
        std::ranges::count(paused_, connection, [](const auto& entry) { return entry.second.connection; });
    return static_cast<std::size_t>(paused) + (own == waiting_.end() ? 0 : own->second.size());
}

std::size_t SlowCallQueue::waiting() const {
    const std::scoped_lock lock(mutex_);
    return count_waiting();
}

std::size_t SlowCallQueue::running() const {
    const std::scoped_lock lock(mutex_);
    return running_;
}

} // namespace server::engine
