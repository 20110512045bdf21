// A time-out that leaves the socket open, so that an answer can still be sent. That of tcp_stream closes it.
#pragma once

#include "gateway/asio.hpp"

#include <memory>

namespace ciel::gateway {

// For the stream's executor only. Must not outlive the stream. Must be stopped before the stream is moved.
class Deadline {
public:
    explicit Deadline(beast::tcp_stream& stream) : stream_(stream), timer_(stream.get_executor()) {}
    ~Deadline() { stop(); }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    // After `time`, pending operations of the stream end with operation_aborted and passed() is true.
    void start(std::chrono::seconds time) {
        stop();
        passed_ = false;
        armed_ = std::make_shared<bool>(true);
        timer_.expires_after(time);
        timer_.async_wait([this, armed = armed_](const error_code&) {
            if (!*armed) return; // stopped while the expiry was queued
            passed_ = true;
            stream_.cancel();
        });
    }
    void stop() {
        if (armed_) *armed_ = false;
        error_code ignored;
        timer_.cancel(ignored);
    }
    [[nodiscard]] bool passed() const { return passed_; }

private:
    beast::tcp_stream& stream_;
    asio::steady_timer timer_;
    std::shared_ptr<bool> armed_; // of the latest start()
    bool passed_ = false;
};

} // namespace ciel::gateway
