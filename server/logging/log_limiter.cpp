#include "logging/log_limiter.hpp"

namespace server::logging {
namespace {

constexpr std::chrono::minutes pause{1};
constexpr std::size_t most_topics = 4096;

} // namespace

bool LogLimiter::allows(const std::string& topic, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (const auto told = told_.find(topic); told != told_.end()) {
        if (now - told->second < pause) return false;
        told->second = now;
        return true;
    }
    if (told_.size() >= most_topics) std::erase_if(told_, [&](const auto& each) { return now - each.second >= pause; });
    if (told_.size() >= most_topics) return false;
    told_.emplace(topic, now);
    return true;
}

} // namespace server::logging
