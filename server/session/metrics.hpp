// Counters of the process, in the Prometheus text exposition format 0.0.4.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace ciel::session {

struct FrameTimes { // milliseconds
    double wait = 0, extract = 0, draw = 0, encode = 0;
};

struct Gauges { // what is true now; the counters count since the start
    std::size_t sessions = 0, connections = 0, views = 0, session_bytes = 0, dataset_bytes = 0, datasets = 0;
    std::size_t busy_workers = 0, slow_calls = 0, slow_calls_waiting = 0;
    std::string gl_renderer, backend;
};

// Thread-safe.
class Metrics {
public:
    void count_frame(bool still, std::size_t bytes, const FrameTimes& times);
    void count_cancelled_frame() { ++cancelled_; }
    void count_failed_frame() { ++failed_; }
    void count_picture(std::size_t bytes);
    void count_request(const std::string& method); // a method of the contract, or "unknown"
    void count_error(int code);

    [[nodiscard]] std::uint64_t interactive_frames() const { return interactive_; }
    [[nodiscard]] std::uint64_t still_frames() const { return stills_; }
    [[nodiscard]] std::string text(const Gauges& gauges) const;

private:
    std::atomic<std::uint64_t> interactive_{0}, stills_{0}, cancelled_{0}, failed_{0}, pictures_{0}, bytes_{0};
    mutable std::mutex mutex_;
    FrameTimes seconds_; // sums, in seconds
    std::map<std::string, std::uint64_t> requests_;
    std::map<int, std::uint64_t> errors_;
};

} // namespace ciel::session
