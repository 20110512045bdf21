// One client: its identity for logs, and the callbacks that send frames and notifications to the client.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace server::sessions {

// A WebSocket sets both send functions, an HTTP POST neither. The callbacks never block and may be called from any
// thread until the Connection is destroyed. On a slow socket, a newer frame may replace a frame that is not sent yet.
struct Connection {
    std::uint64_t id = 0;
    std::string remote;     // address for logs
    std::string user;       // name for logs; empty: not known
    std::string request;    // id of the HTTP request; empty: each call gets its own id
    bool has_token = false; // whether the client sent the server's token; the server's own user needs none
    std::stop_token stop;   // requested when the connection has ended; cancels the connection's calls
    std::function<void(std::string text)> send_text;
    std::function<void(std::shared_ptr<const std::vector<std::uint8_t>> bytes)> send_binary;

    // Returns whether frames of this total size may be sent now. After it has returned false,
    // Sessions::connection_has_room is called when there is room again. If the function is empty, there is always room.
    std::function<bool(std::size_t bytes)> has_room;

    [[nodiscard]] bool may_send(std::size_t bytes) const { return !has_room || has_room(bytes); }
    [[nodiscard]] bool is_streaming() const { return static_cast<bool>(send_binary); }
};

} // namespace server::sessions
