// The binary WebSocket message by which a client sends a piece of an upload (protocol/frame.md).
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace server::wire {

using UploadId = std::array<std::uint8_t, 16>;

struct UploadPiece {
    UploadId upload{};
    std::uint32_t array = 0;             // index of the array in the order of append.begin
    std::uint64_t offset = 0;            // byte offset of `bytes` in the array's values
    std::span<const std::uint8_t> bytes; // view into the message, not owned
};

inline constexpr std::size_t upload_header_bytes = 40;
// Parses a message. The result refers to `message`. Throws Error on a wrong magic number, version, kind, length or
// reserved byte.
[[nodiscard]] UploadPiece read_upload_piece(std::span<const std::uint8_t> message);

} // namespace server::wire
