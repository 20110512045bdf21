// A time-out for reads. Unlike the time-out of beast::tcp_stream, it leaves the socket open, so that an answer can
// still be sent.
#pragma once

#include "gateway/asio.hpp"

#include <memory>

namespace server::gateway {

// Use it only on its stream's executor. It must not outlive the stream, and must be stopped before the stream is moved.
class Deadline {
public:
    explicit Deadline(beast::tcp_stream& stream) : stream_(stream), timer_(stream.get_executor()) {}
    ~Deadline() { stop(); }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    // When `time` has passed, pending operations of the stream end with operation_aborted, and passed() is true.
    void start(std::chrono::seconds time) {
        stop();
        passed_ = false;
        armed_ = std::make_shared<bool>(true);
        timer_.expires_after(time);
        timer_.async_wait([this, armed = armed_](const error_code&) {
            if (!*armed) return; // stop() was called while this handler was queued
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
    std::shared_ptr<bool> armed_; // shared with the handler of the latest start(); false after stop()
    bool passed_ = false;
};

} // namespace server::gateway
