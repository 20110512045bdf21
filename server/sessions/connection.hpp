// Callbacks to one client, by which the lower layers send frames and notifications.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace ciel::sessions {

// A WebSocket has both send functions. For an HTTP POST both are empty, and methods that need them answer with an
// error. The callbacks may be called from any thread until the Connection is destroyed, and never block. When the
// socket is slow, a newer frame of a view may replace an unsent one; the frame loop waits for acknowledgements anyway.
struct Connection {
    std::uint64_t id = 0;
    std::string remote;     // for logs
    std::string user;       // for logs; empty: not known
    std::string request;    // id of the HTTP request; empty: each call gets its own id
    bool has_token = false; // authenticated with the server's token, not merely admitted
    std::stop_token stop;   // requested when the connection has ended; cancels its work
    std::function<void(std::string text)> send_text;
    std::function<void(std::shared_ptr<const std::vector<std::uint8_t>> bytes)> send_binary;

    // Whether frames of this size may be sent now. After it was false, Sessions::connection_has_room is called when
    // there is room again. Empty: always.
    std::function<bool(std::size_t bytes)> has_room;

    [[nodiscard]] bool may_send(std::size_t bytes) const { return !has_room || has_room(bytes); }
    [[nodiscard]] bool is_streaming() const { return static_cast<bool>(send_binary); }
};

} // namespace ciel::sessions
