// LateStepQueue: decides which late steps of datasets are read from their sources, and when. A late step is one whose
// values an import left in the source (store/README.md, "Late arrays").
#pragma once

#include "store/loaded.hpp"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace server::engine {

// Reads the late arrays of a step. Returns the error sentence; empty on success. Takes seconds, and ends soon after
// `cancel` is set. Called from any thread. Must not throw.
using ReadLateStep =
    std::function<std::string(const store::Dataset& dataset, std::size_t step, const std::atomic<bool>& cancel)>;

// Thread-safe. Reads one step at a time for each dataset. The step that was asked for last is read first. Then the
// steps that follow it in time are read ahead of their use. Reading ahead is cancelled when another step is asked for.
class LateStepQueue {
public:
    // tell(directory of the dataset): called on the threads of the queue when a step that was asked for has been read
    // or cannot be read. Must not throw.
    LateStepQueue(ReadLateStep read, std::function<void(const std::filesystem::path&)> tell);
    ~LateStepQueue(); // cancels all reading, and waits for its end

    // Queues the step, and returns at once. After a failure, the step is not read again for five minutes.
    [[nodiscard]] store::LateAnswer ask(const store::Dataset& dataset, std::size_t step);

private:
    struct Work; // for one dataset
    void read_all(Work& work) noexcept;
    void read_wanted(Work& work);
    static void end(Work& work);

    const ReadLateStep read_;
    const std::function<void(const std::filesystem::path&)> tell_;
    std::mutex mutex_; // protects everything below
    bool ending_ = false;
    std::map<std::filesystem::path, std::unique_ptr<Work>> works_; // by directory of the dataset
};

} // namespace server::engine
