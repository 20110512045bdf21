// Cancels the calls of one message when the connection has ended, or when the server is about to stop.
#pragma once

#include <stop_token>

namespace server::methods {

// Thread-safe. A call checks token() at intervals, by CallContext::check_wanted().
class Cancellation {
public:
    Cancellation(const std::stop_token& connection_ended, const std::stop_token& server_stops)
        : on_connection_end_(connection_ended, Request{source_}), on_server_stop_(server_stops, Request{source_}) {}

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

private:
    struct Request {
        std::stop_source& source;
        void operator()() const { source.request_stop(); }
    };

    std::stop_source source_; // declared before the callbacks that use it
    const std::stop_callback<Request> on_connection_end_, on_server_stop_;
};

// Throws Error if stop was requested on one of the tokens. `stop`: token of a Cancellation.
void check_wanted(const std::stop_token& connection_ended, const std::stop_token& stop);

} // namespace server::methods
