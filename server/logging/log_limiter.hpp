// Rate limit for log lines that any client can trigger: one line per minute and topic.
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace server::logging {

// Thread-safe. Remembers at most 4096 topics. If all of them had a line within the last minute, refuses other topics.
class LogLimiter {
public:
    using Clock = std::chrono::steady_clock;

    // Returns whether a line on the topic may be logged now. If so, remembers the time.
    [[nodiscard]] bool allows(const std::string& topic, Clock::time_point now = Clock::now());

private:
    std::mutex mutex_;
    std::map<std::string, Clock::time_point, std::less<>> told_;
};

} // namespace server::logging
