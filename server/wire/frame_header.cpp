#include "wire/frame_header.hpp"

#include "ciel/types.hpp"
#include "wire/bytes.hpp"

#include <algorithm>

namespace ciel::wire {
namespace {

constexpr std::array<std::uint8_t, 4> magic{'C', 'I', 'E', 'L'};
constexpr std::uint8_t version = 2;
constexpr std::uint16_t known_flags = still | last_of_frame | first_of_frame;

} // namespace

void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out) {
    std::fill(out.begin(), out.end(), std::uint8_t{0});
    std::copy(magic.begin(), magic.end(), out.begin());
    std::uint8_t* at = out.data();
    put(at + 4, version);
    put(at + 5, static_cast<std::uint8_t>(header.kind));
    put(at + 6, header.flags);
    put(at + 8, header.view);
    put(at + 12, header.frame);
    put(at + 16, header.revision);
    put(at + 24, header.width);
    put(at + 28, header.height);
    put(at + 32, header.time);
    put(at + 40, header.wait_ms);
    put(at + 44, header.extract_ms);
    put(at + 48, header.draw_ms);
    put(at + 52, header.encode_ms);
    put(at + 56, header.triangles);
    put(at + 60, header.payload_bytes);
    put(at + 64, header.whole_bytes);
    put(at + 68, header.piece_offset);
}

FrameHeader read_frame_header(std::span<const std::uint8_t> bytes) {
    if (bytes.size() < frame_header_bytes) {
        throw Error("a binary frame has " + std::to_string(bytes.size()) + " bytes; its header alone has 80");
    }
    const std::uint8_t* at = bytes.data();
    if (!std::equal(magic.begin(), magic.end(), at)) throw Error("a binary frame does not begin with 'CIEL'");
    if (at[4] != version) {
        throw Error("a binary frame is of version " + std::to_string(at[4]) + "; this program reads version 2");
    }
    if (at[5] != static_cast<std::uint8_t>(FrameKind::image) &&
        at[5] != static_cast<std::uint8_t>(FrameKind::geometry)) {
        throw Error("a binary frame is of kind " + std::to_string(at[5]) + "; there are 1 (image) and 2 (geometry)");
    }
    FrameHeader header;
    header.kind = static_cast<FrameKind>(at[5]);
    header.flags = get<std::uint16_t>(at + 6);
    if ((header.flags & ~known_flags) != 0) {
        throw Error("a binary frame has unknown flags " + std::to_string(header.flags));
    }
    header.view = get<std::uint32_t>(at + 8);
    header.frame = get<std::uint32_t>(at + 12);
    header.revision = get<std::uint64_t>(at + 16);
    header.width = get<std::uint32_t>(at + 24);
    header.height = get<std::uint32_t>(at + 28);
    header.time = get<double>(at + 32);
    header.wait_ms = get<float>(at + 40);
    header.extract_ms = get<float>(at + 44);
    header.draw_ms = get<float>(at + 48);
    header.encode_ms = get<float>(at + 52);
    header.triangles = get<std::uint32_t>(at + 56);
    header.payload_bytes = get<std::uint32_t>(at + 60);
    if (bytes.size() != frame_header_bytes + header.payload_bytes) {
        throw Error("a binary frame announces " + std::to_string(header.payload_bytes) +
                    " bytes after its header and has " + std::to_string(bytes.size() - frame_header_bytes));
    }
    header.whole_bytes = get<std::uint32_t>(at + 64);
    header.piece_offset = get<std::uint32_t>(at + 68);
    if (header.piece_offset > header.whole_bytes || header.payload_bytes > header.whole_bytes - header.piece_offset) {
        throw Error("a binary frame brings " + std::to_string(header.payload_bytes) + " bytes from " +
                    std::to_string(header.piece_offset) + " on, and the whole has " +
                    std::to_string(header.whole_bytes));
    }
    return header;
}

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

} // namespace ciel::wire
