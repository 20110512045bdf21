// Send queue of one WebSocket: texts first, then frames in pieces. Its memory is bounded. Half of the limit is for
// frames, which are delayed when it is full. Half is for texts, which end the connection when it is exceeded.
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

// Payload bytes of one message. A text waits for the current piece: 52 ms at 10 Mbit/s.
inline constexpr std::uint32_t piece_bytes = 64 << 10;
// A frame whose first message has at least measuring_bytes begins with a short piece. The client measures the line rate
// from the arrival times of this piece and the following ones, which are sent back to back.
inline constexpr std::uint32_t first_piece_bytes = 4 << 10, measuring_bytes = first_piece_bytes + (32 << 10);
static_assert(wire::frame_header_bytes + piece_bytes <= wire::longest_message);

// Thread-safe. Outlives its socket: pushing after close() does nothing.
class Outbox {
public:
    struct Message {
        std::string text;
        FrameBytes frame;                                          // owns the bytes of `payload`; null: a text
        std::array<std::uint8_t, wire::frame_header_bytes> header; // of a piece of the frame
        std::span<const std::uint8_t> payload;
    };

    // on_push is called after every push, on the pushing thread, with the outbox locked: it must not call back.
    // `memory` counts the bytes and must outlive the outbox.
    Outbox(std::size_t most_bytes, limits::Memory& memory, std::function<void()> on_push);

    // If the waiting texts already exceed their half, the client does not read: drops everything and sets overflowed().
    // A single text may be larger than the limit.
    void push_text(std::string text);
    // A whole frame message (protocol/frame.md) of any length. The first message of a frame replaces all older messages
    // of its view, including the rest of a partly sent one. Throws Error when it does not begin with a frame header, or
    // is only a piece.
    void push_frame(FrameBytes bytes);
    // Whether a frame of this size fits. One above the limit fits only if no other frame waits.
    [[nodiscard]] bool has_room(std::size_t bytes);
    void close();

    // Returns the oldest text, else the next piece of the oldest frame message. The bytes of a frame message are
    // counted until its last piece has been sent.
    [[nodiscard]] std::optional<Message> pop();
    // Call after the message of pop() was written. Returns true if has_room() was false before and there is room again.
    [[nodiscard]] bool sent();
    [[nodiscard]] bool overflowed() const;
    [[nodiscard]] std::uint64_t dropped_frames() const; // replaced messages

private:
    struct Waiting {
        FrameBytes bytes;
        wire::FrameHeader header;
        std::uint32_t sent = 0; // bytes of the payload
        [[nodiscard]] std::uint32_t next_piece_bytes() const;
    };
    void count();  // REQUIRES: the lock
    void forget(); // likewise

    mutable std::mutex mutex_;
    std::function<void()> on_push_; // empty: closed
    std::deque<std::string> texts_;
    std::deque<Waiting> frames_;
    std::size_t share_;                            // half of the limit: for texts, and for frames
    std::size_t text_bytes_ = 0, frame_bytes_ = 0; // waiting
    std::size_t text_taken_ = 0, frame_taken_ = 0; // being sent; of a frame only during its last piece
    bool had_no_room_ = false;
    limits::Memory::Charge held_;
    std::uint64_t dropped_ = 0;
    bool overflowed_ = false;
};

} // namespace ciel::gateway
