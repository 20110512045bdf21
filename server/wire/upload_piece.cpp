#include "wire/upload_piece.hpp"

#include "ciel/types.hpp"
#include "wire/bytes.hpp"

#include <algorithm>

namespace server::wire {
namespace {

constexpr std::array<std::uint8_t, 4> magic{'C', 'I', 'E', 'L'};
constexpr std::uint8_t version = 1, kind = 16;

} // namespace

UploadPiece read_upload_piece(std::span<const std::uint8_t> message) {
    if (message.size() < upload_header_bytes)
        throw ciel::Error("a piece of an upload has " + std::to_string(message.size()) +
                          " bytes; its header alone has 40");
    const std::uint8_t* at = message.data();
    if (!std::equal(magic.begin(), magic.end(), at)) throw ciel::Error("a binary message does not begin with 'CIEL'");
    if (at[4] != version)
        throw ciel::Error("a binary message is of version " + std::to_string(at[4]) + "; this server reads version 1");
    if (at[5] != kind)
        throw ciel::Error("a binary message is of kind " + std::to_string(at[5]) +
                          "; this server accepts only kind 16 (upload)");
    if (get<std::uint16_t>(at + 6) != 0) throw ciel::Error("a piece of an upload has flags; set the flags to 0");
    UploadPiece piece;
    std::copy_n(at + 8, piece.upload.size(), piece.upload.begin());
    piece.array = get<std::uint32_t>(at + 24);
    const auto bytes = get<std::uint32_t>(at + 28);
    piece.offset = get<std::uint64_t>(at + 32);
    piece.bytes = message.subspan(upload_header_bytes);
    if (piece.bytes.size() != bytes)
        throw ciel::Error("a piece of an upload announces " + std::to_string(bytes) +
                          " bytes after its header and has " + std::to_string(piece.bytes.size()));
    return piece;
}

} // namespace server::wire
