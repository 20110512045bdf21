// The header before every binary WebSocket frame: 80 bytes, little-endian (protocol/frame.md).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

enum class FrameKind : std::uint8_t { image = 1, geometry = 2 };
enum FrameFlags : std::uint16_t {
    still = 1,          // the lossless full-size picture, the last of this revision
    last_of_frame = 2,  // geometry: no further message of this frame follows
    first_of_frame = 4, // geometry: drop the batches of earlier frames of this view
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
    std::uint32_t whole_bytes = 0, piece_offset = 0; // size of the picture or batch; offset of this message in it
};

inline constexpr std::size_t frame_header_bytes = 80;
inline constexpr std::size_t longest_message = 512 << 10; // sent by the server, with header: proxies cut longer ones

void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out);
// Throws Error on a bad magic, version, kind, flag or size.
[[nodiscard]] FrameHeader read_frame_header(std::span<const std::uint8_t> bytes);
// Returns the header of the piece that begins at byte `offset` of the whole payload and has at most `most` bytes. Only
// the first piece keeps first_of_frame, only the last keeps last_of_frame.
[[nodiscard]] FrameHeader piece_of(const FrameHeader& whole, std::uint32_t offset, std::uint32_t most);

} // namespace ciel::wire
