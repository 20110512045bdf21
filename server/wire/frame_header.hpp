// The header of every binary WebSocket message from the server: 80 bytes, little-endian (protocol/frame.md). The
// structure, its writer and its reader are generated from protocol/frame_header.json.
#pragma once

#include "protocol/frame_header.hpp"

namespace server::wire {

// Largest size in bytes of a WebSocket message from the server, with the header. Proxies close a socket on longer
// messages.
inline constexpr std::size_t longest_message = 512 << 10;

// Returns the header of the piece that begins at byte `offset` of the whole payload and has at most `most` payload
// bytes. Only the first piece keeps first_of_frame. Only the last piece keeps last_of_frame.
[[nodiscard]] FrameHeader piece_of(const FrameHeader& whole, std::uint32_t offset, std::uint32_t most);

} // namespace server::wire
