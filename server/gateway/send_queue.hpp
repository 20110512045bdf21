// Send queue of one WebSocket. Texts are sent first, then frames in pieces. A newer frame of a view drops its frames
// that still wait. Half of the byte limit is for frames, which wait when it is full. The other half is for texts; when
// texts exceed it, the connection ends.
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

namespace server::gateway {

using FrameBytes = std::shared_ptr<const std::vector<std::uint8_t>>;

// Payload bytes of a piece. A text waits until the current piece has been sent, which takes 52 ms at 10 Mbit/s.
inline constexpr std::uint32_t piece_bytes = 64 << 10;
// A frame of measuring_bytes or more begins with a short piece. From the arrival times of the pieces, the client
// measures the line rate.
inline constexpr std::uint32_t first_piece_bytes = 4 << 10, measuring_bytes = first_piece_bytes + (32 << 10);
static_assert(wire::frame_header_bytes + piece_bytes <= wire::longest_message);

// Thread-safe. May outlive its socket, because pushing does nothing after close().
class SendQueue {
public:
    struct Message {
        std::string text;
        FrameBytes frame; // owns the bytes of `payload`; null if the message is a text
        std::array<std::uint8_t, wire::frame_header_bytes> header; // header of a piece of the frame
        std::span<const std::uint8_t> payload;
    };

    // `on_push` is called on the pushing thread while the queue is locked, so it must not call the queue. `memory`
    // counts the bytes and must outlive the queue.
    SendQueue(std::size_t most_bytes, limits::Memory& memory, std::function<void()> on_push);

    // If the waiting texts already exceed their half of the limit, the client does not read. Then all waiting messages
    // are dropped, and overflowed() becomes true. A single text may exceed the limit.
    void push_text(std::string text);
    // The first message of a frame replaces all waiting messages of the same view, even one that is partly sent. Throws
    // Error if `bytes` is only a piece of a message, or has no frame header.
    void push_frame(FrameBytes bytes);
    // Returns whether a frame of this size fits. A frame larger than the limit fits only if no other frame waits.
    [[nodiscard]] bool has_room(std::size_t bytes);
    void close();

    // Texts come before frames. The bytes of a frame message are counted until its last piece has been sent.
    [[nodiscard]] std::optional<Message> pop();
    // Call this after a message was written. Returns true if has_room() returned false before and there is room again.
    [[nodiscard]] bool sent();
    [[nodiscard]] bool overflowed() const;
    [[nodiscard]] std::uint64_t dropped_frames() const; // frame messages replaced by newer messages

private:
    struct Waiting {
        FrameBytes bytes;
        wire::FrameHeader header;
        std::uint32_t sent = 0; // payload bytes that pop() has returned
        [[nodiscard]] std::uint32_t next_piece_bytes() const;
    };
    void count();  // reports the bytes to held_; requires mutex_ to be held
    void forget(); // drops all waiting messages; requires mutex_ to be held

    mutable std::mutex mutex_;
    std::function<void()> on_push_; // empty after close()
    std::deque<std::string> texts_;
    std::deque<Waiting> frames_;
    std::size_t share_;                            // half of the limit in bytes: the share of texts, and of frames
    std::size_t text_bytes_ = 0, frame_bytes_ = 0; // bytes that wait
    std::size_t text_taken_ = 0, frame_taken_ = 0; // bytes that are being sent; for a frame, only during its last piece
    bool had_no_room_ = false;
    limits::Memory::Charge held_;
    std::uint64_t dropped_ = 0;
    bool overflowed_ = false;
};

} // namespace server::gateway
