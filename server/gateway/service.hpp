// Interfaces behind the gateway: Service for the process, Peer for one client. The gateway does not know the methods.
#pragma once

#include "limits/limits.hpp"
#include "limits/memory.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace server::gateway {

// One client of the process. A WebSocket sets all three callbacks; an HTTP POST sets none. The callbacks never block
// and may be called from any thread until the Client is destroyed. On a slow socket, a newer frame replaces waiting
// frames.
struct Client {
    std::uint64_t id = 0;
    std::string remote;     // address, for logs
    std::string user{};     // name for logs; empty: not known
    std::string request{};  // id of the HTTP request; empty for a WebSocket
    bool has_token = false; // whether the client sent the server's token; the server's own user needs none
    std::stop_token stop{}; // requested when the connection has ended
    std::function<void(std::string text)> send_text{};
    std::function<void(std::shared_ptr<const std::vector<std::uint8_t>> bytes)> send_binary{};
    std::function<bool(std::size_t bytes)> has_room{}; // returns whether a frame of this size may be sent now
};

// Called exactly once, from any thread. The text is empty if the message needs no answer. Must not throw.
using Answer = std::function<void(std::string text)>;

// The process's side of one client. text() and binary() run on worker threads, one at a time. closed() may be called
// meanwhile. No function throws.
class Peer {
public:
    virtual ~Peer() = default;

    // Handles a text. `text` is valid only until the call returns. `answer` may be called later.
    virtual void text(std::string_view text, Answer answer) = 0;
    // Handles a binary message. Returns the reason to close the connection, or nothing.
    [[nodiscard]] virtual std::optional<std::string> binary(std::span<const std::uint8_t> message) = 0;
    // Called when Client::has_room() would return true again. Runs on the socket's thread and must not block.
    virtual void has_room() = 0;
    // Called when the client has closed the connection. Not called for a POST whose client stays until the answer.
    virtual void closed() = 0;
};

struct Readiness {
    bool ready = false;
    std::string problem{};                                    // a sentence; empty when ready
    std::vector<std::pair<std::string, std::string>> facts{}; // name and value
};

// The process behind the gateway. All functions are thread-safe.
class Service {
public:
    virtual ~Service() = default;

    [[nodiscard]] virtual const limits::Limits& limits() const = 0;
    [[nodiscard]] virtual limits::Memory& memory() = 0; // counts the bytes that wait to be sent
    [[nodiscard]] virtual std::shared_ptr<Peer> connect(Client client) = 0;
    [[nodiscard]] virtual Readiness readiness() = 0; // may block briefly
    [[nodiscard]] virtual std::string metrics() = 0; // Prometheus text exposition format 0.0.4

    // announce_end(), drain_frames() and drain() are called in this order; give_up() may be called during drain().
    // announce_end() notifies clients and does not block.
    virtual void announce_end() = 0;
    virtual void drain_frames() = 0; // starts no new frames; returns when no frame is in progress
    virtual void drain() = 0;        // returns when all running calls have ended
    virtual void give_up() = 0;      // cancels running calls, so that drain() returns soon; does not block
};

} // namespace server::gateway
