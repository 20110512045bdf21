// What waits to be sent on one WebSocket: texts first, then frames in pieces. A slow client costs a bounded amount of
// memory: half of the limit is for frames, which are made later where they find no room, half for answers, which end
// the connection when they pile up.
#pragma once

#include "limits/memory.hpp"
#include "wire/frame_header.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ciel::gateway {

using FrameBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

// Payload bytes of one message. A text waits for the piece under way: 52 ms on a line of 10 Mbit/s.
inline constexpr std::uint32_t piece_bytes = 64 << 10;
// A frame whose first message is so long begins with a short piece: the client measures the line by the time from it to
// the pieces behind it, which are on the line together.
inline constexpr std::uint32_t first_piece_bytes = 4 << 10, measuring_bytes = first_piece_bytes + (32 << 10);
static_assert(wire::frame_header_bytes + piece_bytes <= wire::longest_message);

// Thread-safe. Outlives its socket: pushing after close() does nothing.
class Outbox {
public:
    struct Message {
        std::string text;
        FrameBytes frame;                                          // null: a text. Owns the bytes of `payload`
        std::array<std::uint8_t, wire::frame_header_bytes> header; // of a piece of the frame
        std::span<const std::uint8_t> payload;
    };

    // on_push is called after every push, from the pushing thread, with the outbox locked: it must not call back.
    // memory: where the bytes are counted; must outlive the outbox.
    Outbox(std::size_t most_bytes, limits::Memory& memory, std::function<void()> on_push);

    // When the texts that wait already exceed their half, the client does not read its answers: everything is dropped
    // and overflowed() is true from then on. (One answer may be larger than the limit.)
    void push_text(std::string text);
    // A whole frame message (protocol/frame.md) of any length. The first message of a frame takes the place of every
    // older one of its view, also of what is left of one that has been sent in part. Throws Error when it does not
    // begin with a frame header.
    void push_frame(FrameBytes bytes);
    // Whether a frame of so many bytes keeps the limit. One that is larger has room when no other is there.
    [[nodiscard]] bool has_room(std::size_t bytes);
    void close();

    // The oldest text; without one the next piece of the oldest frame message, whose bytes count until its last piece
    // has been sent.
    [[nodiscard]] std::optional<Message> pop();
    // The message of the last pop() has been written. True when has_room() was false before and there is room again.
    [[nodiscard]] bool sent();
    [[nodiscard]] bool overflowed() const;
    [[nodiscard]] std::uint64_t dropped_frames() const; // messages that were replaced

private:
    struct Waiting {
        FrameBytes bytes;
        wire::FrameHeader header;
        std::uint32_t sent = 0; // of the payload
        [[nodiscard]] std::uint32_t next_piece_bytes() const;
    };
    void count();  // REQUIRES: the lock
    void forget(); // likewise

    mutable std::mutex mutex_;
    std::function<void()> on_push_; // empty: closed
    std::deque<std::string> texts_;
    std::deque<Waiting> frames_;
    std::size_t share_;                            // of texts, and of frames
    std::size_t text_bytes_ = 0, frame_bytes_ = 0; // that wait
    std::size_t text_taken_ = 0, frame_taken_ = 0; // of the message under way; of a frame when it is the last piece
    bool had_no_room_ = false;
    limits::Memory::Charge held_;
    std::uint64_t dropped_ = 0;
    bool overflowed_ = false;
};

} // namespace ciel::gateway
