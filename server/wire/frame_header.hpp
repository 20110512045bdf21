// The header before every binary WebSocket frame: 80 bytes, little-endian (protocol/frame.md).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

enum class FrameKind : std::uint8_t { image = 1, geometry = 2 };
enum FrameFlags : std::uint16_t {
    still = 1,          // the lossless full-size picture: nothing better follows for this revision
    last_of_frame = 2,  // geometry: no further message of this frame follows
    first_of_frame = 4, // geometry: drop what earlier frames sent for this view
};

struct FrameHeader {
    FrameKind kind = FrameKind::image;
    std::uint16_t flags = 0;
    std::uint32_t view = 0, frame = 0;
    std::uint64_t revision = 0; // of the scene that the frame shows
    std::uint32_t width = 0, height = 0;
    double time = 0; // simulation time shown
    float wait_ms = 0, extract_ms = 0, draw_ms = 0, encode_ms = 0;
    std::uint32_t triangles = 0;
    std::uint32_t payload_bytes = 0;                 // of this message
    std::uint32_t whole_bytes = 0, piece_offset = 0; // of the picture or batch, and where the message's bytes lie in it
};

inline constexpr std::size_t frame_header_bytes = 80;
inline constexpr std::size_t longest_message = 512 << 10; // of the server, header included: proxies cut longer ones

void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out);
// Throws Error on a bad magic, version or size.
[[nodiscard]] FrameHeader read_frame_header(std::span<const std::uint8_t> bytes);
// Header of the piece of a whole message that begins at `offset` of its payload and has at most `most` bytes of it. The
// flags for the first and the last message of a frame stay with the first and the last piece.
[[nodiscard]] FrameHeader piece_of(const FrameHeader& whole, std::uint32_t offset, std::uint32_t most);

} // namespace ciel::wire
