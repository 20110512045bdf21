#include "engine/schedule/late_step_queue.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace server::engine {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::minutes failure_lasts{5};
constexpr std::size_t steps_ahead = 2, most_wanted = 8; // older requests are dropped; their views ask again

} // namespace

struct LateStepQueue::Work {
    std::string id;                                // id of the dataset
    std::shared_ptr<const store::Dataset> dataset; // null while no step is wanted
    std::vector<std::size_t> wanted;               // steps that were asked for; the last one is read first
    std::vector<std::size_t> ahead;                // steps that follow the step that was asked for last
    std::optional<std::size_t> running;
    struct Failure {
        std::string problem;
        Clock::time_point at;
    };
    std::map<std::size_t, Failure> failures; // by step
    std::atomic<bool> cancel{false};
    bool is_running = false;
    std::jthread thread;
};

LateStepQueue::LateStepQueue(ReadLateStep read, std::function<void(const std::filesystem::path&)> tell)
    : read_(std::move(read)), tell_(std::move(tell)) {}

LateStepQueue::~LateStepQueue() {
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
        for (auto& [directory, work] : works_) work->cancel = true;
    }
    works_.clear(); // waits for the threads
}

store::LateAnswer LateStepQueue::ask(const store::Dataset& dataset, std::size_t step) {
    const std::scoped_lock lock(mutex_);
    auto& found = works_[dataset.directory()];
    if (!found) found = std::make_unique<Work>();
    Work& work = *found;
    if (work.id != dataset.info().id) { // another dataset is in the same directory now
        work.id = dataset.info().id;
        work.failures.clear();
        work.wanted.clear();
        work.ahead.clear();
    }
    if (const auto failure = work.failures.find(step); failure != work.failures.end()) {
        if (Clock::now() - failure->second.at < failure_lasts)
            return {"cannot be read from its source: " + failure->second.problem, true};
        work.failures.erase(failure);
    }
    if (ending_) return {"is not read any more, because the server is about to stop", true};
    work.dataset = dataset.shared_from_this();
    std::erase(work.wanted, step);
    work.wanted.push_back(step);
    if (work.wanted.size() > most_wanted) work.wanted.erase(work.wanted.begin());
    const bool is_running_another = work.running && *work.running != step;
    if (is_running_another && std::ranges::find(work.wanted, *work.running) == work.wanted.end()) work.cancel = true;
    if (!work.is_running) {
        work.thread = std::jthread([this, &work] { read_all(work); });
        work.is_running = true;
    }
    return {"is being read from its source", false};
}

// Requires mutex_ to be held.
void LateStepQueue::end(Work& work) {
    work.running.reset();
    work.is_running = false;
    work.dataset.reset();
}

void LateStepQueue::read_all(Work& work) noexcept {
    try {
        read_wanted(work);
    } catch (const std::exception&) { // memory is short; the next request begins again
        const std::scoped_lock lock(mutex_);
        work.wanted.clear();
        end(work);
    }
}

void LateStepQueue::read_wanted(Work& work) {
    std::unique_lock lock(mutex_);
    while (!ending_ && (!work.wanted.empty() || !work.ahead.empty())) {
        const bool is_asked_for = !work.wanted.empty();
        const std::size_t step = is_asked_for ? work.wanted.back() : work.ahead.front();
        if (!is_asked_for) work.ahead.erase(work.ahead.begin());
        work.running = step;
        work.cancel = false;
        const auto dataset = work.dataset;
        lock.unlock();
        const std::string problem = read_(*dataset, step, work.cancel);
        lock.lock();
        work.running.reset();
        if (ending_) break;
        const bool was_asked_for = std::erase(work.wanted, step) > 0 || is_asked_for;
        if (!problem.empty() && !work.cancel) work.failures[step] = {problem, Clock::now()};
        if (!was_asked_for) continue;
        work.ahead.clear();
        for (std::size_t next = step + 1; problem.empty() && next <= step + steps_ahead; ++next)
            if (next < dataset->steps().size()) work.ahead.push_back(next);
        lock.unlock();
        tell_(dataset->directory());
        lock.lock();
    }
    end(work); // under the same lock as the last check of `wanted`, so that no request is missed
}

} // namespace server::engine
