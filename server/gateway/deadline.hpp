// A time-out that leaves the socket open, so that the peer can still be told; a tcp_stream's own closes it.
#pragma once

#include "gateway/asio.hpp"

#include <memory>

namespace ciel::gateway {

// Used on the stream's executor only; must not outlive the stream, nor be running when the stream is moved away.
class Deadline {
public:
    explicit Deadline(beast::tcp_stream& stream) : stream_(stream), timer_(stream.get_executor()) {}
    ~Deadline() { stop(); }
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    // When the time is over, what waits on the stream ends with operation_aborted, and passed() is true.
    void start(std::chrono::seconds time) {
        stop();
        passed_ = false;
        armed_ = std::make_shared<bool>(true);
        timer_.expires_after(time);
        timer_.async_wait([this, armed = armed_](const error_code&) {
            if (!*armed) return; // also when the expiry was already on its way
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
    std::shared_ptr<bool> armed_; // of the latest start
    bool passed_ = false;
};

} // namespace ciel::gateway
