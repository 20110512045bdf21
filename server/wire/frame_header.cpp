#include "wire/frame_header.hpp"

namespace server::wire {

FrameHeader piece_of(const FrameHeader& whole, std::uint32_t offset, std::uint32_t most) {
    FrameHeader piece = whole;
    piece.piece_offset = offset;
    piece.payload_bytes = std::min(most, whole.whole_bytes - offset);
    constexpr auto without = [](std::uint16_t flags, std::uint16_t flag) {
        return static_cast<std::uint16_t>(flags & ~flag);
    };
    if (offset > 0) piece.flags = without(piece.flags, first_of_frame);
    if (offset + piece.payload_bytes < whole.whole_bytes) piece.flags = without(piece.flags, last_of_frame);
    return piece;
}

} // namespace server::wire
