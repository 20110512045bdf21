// Counters of the process, in the Prometheus text exposition format 0.0.4.
#pragma once

#include "limits/memory.hpp"

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <ostream>
#include <string>

namespace server::engine {

struct FrameTimes { // milliseconds
    double wait = 0, extract = 0, draw = 0, encode = 0;
};

struct Gauges { // current values; the counters in Metrics count since the start of the process
    std::size_t sessions = 0, connections = 0, views = 0, session_bytes = 0, dataset_bytes = 0, datasets = 0;
    std::array<std::uint64_t, limits::held_names.size()> held_bytes{};
    std::uint64_t memory_limit = 0;
    std::size_t busy_workers = 0, slow_calls = 0, slow_calls_waiting = 0;
    std::string gl_renderer{}, backend{}, version{};
};

// Counts durations in buckets with fixed upper bounds. Not thread-safe.
class DurationHistogram {
public:
    // Upper bounds in seconds, from a quick call to a picture of a large mesh that is drawn in software.
    static constexpr std::array bounds{0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25,
                                       0.5,   1.0,    2.5,   5.0,  10.0,  30.0, 60.0};

    void add(double seconds);
    // Writes the samples of one metric family. `labels`: the labels of all samples, such as "method=\"scene.get\"".
    void write(std::ostream& out, const char* family, const std::string& labels) const;

private:
    std::array<std::uint64_t, bounds.size() + 1> counts_{}; // by bucket; the last element counts longer durations
    double sum_ = 0;
};

// All members of Metrics are thread-safe.
class Metrics {
public:
    void count_call(const std::string& method, double seconds); // `seconds`: time without the wait in the queue
    void count_frame(bool still, std::size_t bytes, const FrameTimes& times);
    void count_cancelled_frame() { ++cancelled_; }
    void count_failed_frame() { ++failed_; }
    void count_picture(std::size_t bytes);
    void count_request(const std::string& method); // a method of openrpc.json, or "unknown"
    void count_error(int code);

    [[nodiscard]] std::uint64_t interactive_frames() const { return interactive_; }
    [[nodiscard]] std::uint64_t still_frames() const { return stills_; }
    [[nodiscard]] std::string text(const Gauges& gauges) const;

private:
    std::atomic<std::uint64_t> interactive_{0}, stills_{0}, cancelled_{0}, failed_{0}, pictures_{0}, bytes_{0};
    mutable std::mutex mutex_;
    FrameTimes seconds_; // sums over all frames, in seconds instead of milliseconds
    std::map<std::string, DurationHistogram> calls_;
    DurationHistogram interactive_seconds_, still_seconds_;
    std::map<std::string, std::uint64_t> requests_;
    std::map<int, std::uint64_t> errors_;
};

} // namespace server::engine
