// What stands behind the gateway: a service answers for the process, a peer for one client. The gateway knows no
// method.
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

namespace ciel::gateway {

// A client and the way back to it. A WebSocket has all three callbacks; an HTTP POST has none. They may be called from
// any thread until the Client is destroyed, never block, and may drop frames newest-wins when the socket is slow.
struct Client {
    std::uint64_t id = 0;
    std::string remote;     // address, for logs
    std::string user{};     // for logs; empty: not known
    std::string request{};  // id of the HTTP request; empty for a WebSocket
    bool has_token = false; // it came with the server's token, which is more than being let in
    std::stop_token stop{}; // requested when the connection has ended
    std::function<void(std::string text)> send_text{};
    std::function<void(std::shared_ptr<const std::vector<std::uint8_t>> bytes)> send_binary{};
    std::function<bool(std::size_t bytes)> has_room{}; // whether frames of this size may be sent now
};

// Called exactly once, from any thread. An empty text: there is nothing to answer. Must not throw.
using Answer = std::function<void(std::string text)>;

// Takes the messages of one client. Called on worker threads, one call at a time except closed(). Never throws.
class Peer {
public:
    virtual ~Peer() = default;

    // `text` is borrowed until the call returns; the answer may come later.
    virtual void text(std::string_view text, Answer answer) = 0;
    // Returns why the connection has to be closed, or nothing.
    [[nodiscard]] virtual std::optional<std::string> binary(std::span<const std::uint8_t> message) = 0;
    // There is room again after Client::has_room was false. On the socket's thread: must not block.
    virtual void has_room() = 0;
    // The client has gone. A POST whose client stays until its answer is not told.
    virtual void closed() = 0;
};

struct Readiness {
    bool ready = false;
    std::string problem{};                                    // a sentence; empty when ready
    std::vector<std::pair<std::string, std::string>> facts{}; // name and value, for people
};

// Thread-safe.
class Service {
public:
    virtual ~Service() = default;

    [[nodiscard]] virtual const limits::Limits& limits() const = 0;
    [[nodiscard]] virtual limits::Memory& memory() = 0; // counts what waits for sockets
    [[nodiscard]] virtual std::shared_ptr<Peer> connect(Client client) = 0;
    [[nodiscard]] virtual Readiness readiness() = 0; // waits for a moment
    [[nodiscard]] virtual std::string metrics() = 0; // Prometheus text exposition format 0.0.4

    // The end, in this order. announce_end: clients are told; does not block.
    virtual void announce_end() = 0;
    virtual void drain_frames() = 0; // no new frames; returns when none is under way
    virtual void drain() = 0;        // returns when the calls under way have ended
    virtual void give_up() = 0;      // calls under way end as soon as they can; does not block
};

} // namespace ciel::gateway
