// StepReader: reads late steps of datasets from their sources when a user needs them, and the next ones ahead.
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

namespace server::importing {

// Thread-safe. Runs at most one ciel-import for each dataset. A step that is asked for ends an import of steps ahead.
class StepReader {
public:
    // `folder`: of late arrays whose dataset cannot be written to. tell(directory of the dataset): called on the
    // threads of the reader when a step that was asked for has been read or cannot be read. Must not throw.
    StepReader(std::filesystem::path folder, std::function<void(const std::filesystem::path&)> tell);
    ~StepReader(); // ends all imports

    // Returns at once. After a failure, the step is not read again for five minutes.
    [[nodiscard]] store::LateAnswer ask(const store::Dataset& dataset, std::size_t step);

private:
    struct Work; // for one dataset
    void read_all(Work& work) noexcept;
    void read_wanted(Work& work);
    static void end(Work& work);
    [[nodiscard]] std::string read(const store::Dataset& dataset, std::size_t step,
                                   const std::atomic<bool>& cancel) const;

    const std::filesystem::path folder_;
    const std::function<void(const std::filesystem::path&)> tell_;
    std::mutex mutex_; // protects everything below
    bool ending_ = false;
    std::map<std::filesystem::path, std::unique_ptr<Work>> works_; // by directory of the dataset
};

} // namespace server::importing
