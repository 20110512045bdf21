// For log lines that strangers can cause as often as they like: one a minute and topic.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace ciel::logging {

// Thread-safe. Remembers at most 4096 topics; while that many were heard of within the minute, new ones are not told.
class LogLimiter {
public:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool allows(const std::string& topic, Clock::time_point now = Clock::now());

private:
    std::mutex mutex_;
    std::map<std::string, Clock::time_point, std::less<>> told_;
};

} // namespace ciel::logging
