// What waits to be sent on one WebSocket. A slow client costs a bounded amount of memory: of each view only the newest
// frame waits, and answers that pile up end the connection.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace ciel::gateway {

using FrameBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

// Thread-safe. Outlives its socket: pushing after close() does nothing.
class Outbox {
public:
    struct Message {
        std::string text;
        FrameBytes frame; // null: a text
    };

    // on_push is called after every push, from the pushing thread, with the outbox locked: it must not call back.
    Outbox(std::size_t text_limit_bytes, std::function<void()> on_push);

    // When the texts that wait already exceed the limit, the client does not read its answers: everything is dropped
    // and overflowed() is true from then on. (One answer may be larger than the limit.)
    void push_text(std::string text);
    // A frame message (protocol/frame.md). The first message of a frame takes the place of every older one of its view.
    // Throws Error when it does not begin with a frame header.
    void push_frame(FrameBytes bytes);
    void close();

    [[nodiscard]] std::optional<Message> pop();
    [[nodiscard]] bool overflowed() const;
    [[nodiscard]] std::uint64_t dropped_frames() const; // messages that were replaced

private:
    struct Waiting {
        Message message;
        std::uint32_t view = 0;
    };
    mutable std::mutex mutex_;
    std::function<void()> on_push_; // empty: closed
    std::deque<Waiting> waiting_;
    std::size_t text_limit_, text_bytes_ = 0;
    std::uint64_t dropped_ = 0;
    bool overflowed_ = false;
};

} // namespace ciel::gateway
