// One client's way back: what the gateway gives the lower layers so that frames and notifications can leave.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace ciel::sessions {

// A WebSocket has both ways; an HTTP POST has neither (both empty), and methods that need one answer with an error.
// The callbacks may be called from any thread until the Connection is destroyed, never block, and may drop frames of a
// view newest-wins when the socket is slow (the frame loop waits for acknowledgements anyway).
struct Connection {
    std::uint64_t id = 0;
    std::string remote;     // for logs
    std::string user;       // for logs; empty: not known
    std::string request;    // id of the HTTP request that the calls came in; empty: each call gets one of its own
    bool has_token = false; // it came with the server's token, which is more than being let in
    std::stop_token stop;   // requested when the connection has ended: what is being made for it is given up
    std::function<void(std::string text)> send_text;
    std::function<void(std::shared_ptr<const std::vector<std::uint8_t>> bytes)> send_binary;

    // Whether frames of so many bytes may be sent now. Once it was false, the views are told when there is room again
    // (Sessions::connection_has_room). Empty: always.
    std::function<bool(std::size_t bytes)> has_room;

    [[nodiscard]] bool may_send(std::size_t bytes) const { return !has_room || has_room(bytes); }
    [[nodiscard]] bool is_streaming() const { return static_cast<bool>(send_binary); }
};

} // namespace ciel::sessions
