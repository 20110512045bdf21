#include "ciel/types.hpp"
#include "decode.hpp"
#include "pictures.hpp"
#include "wire/frame_header.hpp"
#include "wire/pictures/png.hpp"

#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::wire {
using namespace ciel;
namespace {

using Bytes = std::vector<std::uint8_t>;

FrameHeader sample() {
    FrameHeader header;
    header.kind = FrameKind::geometry;
    header.flags = first_of_frame | still;
    header.view = 0x01020304;
    header.frame = 7;
    header.revision = 0x1122334455667788;
    header.width = 1280;
    header.height = 720;
    header.time = 0.5;
    header.wait_ms = 1;
    header.extract_ms = 2;
    header.draw_ms = 3;
    header.encode_ms = 4;
    header.triangles = 100000;
    header.payload_bytes = 2;
    header.whole_bytes = 9;
    header.piece_offset = 4;
    return header;
}

Bytes message_of(const FrameHeader& header) {
    Bytes bytes(frame_header_bytes);
    write_frame_header(header, std::span<std::uint8_t, frame_header_bytes>(bytes));
    bytes.resize(frame_header_bytes + header.payload_bytes);
    return bytes;
}

TEST(FrameHeader, HasTheDocumentedBytes) {
    const Bytes golden{'C',  'I',  'E',  'L',  2,    2,    5,    0,    4,    3,    2,    1,    7,    0, 0, 0,
                       0x88, 0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11, 0,    5,    0,    0,    0xd0, 2, 0, 0,
                       0,    0,    0,    0,    0,    0,    0xe0, 0x3f, 0,    0,    0x80, 0x3f, 0,    0, 0, 0x40,
                       0,    0,    0x40, 0x40, 0,    0,    0x80, 0x40, 0xa0, 0x86, 1,    0,    2,    0, 0, 0,
                       9,    0,    0,    0,    4,    0,    0,    0,    0,    0,    0,    0,    0,    0, 0, 0};
    Bytes written = message_of(sample());
    written.resize(frame_header_bytes);
    EXPECT_EQ(written, golden);
}

TEST(FrameHeader, ComesBackAsItWas) {
    const FrameHeader in = sample();
    const FrameHeader out = read_frame_header(message_of(in));
    EXPECT_EQ(out.kind, in.kind);
    EXPECT_EQ(out.flags, in.flags);
    EXPECT_EQ(out.view, in.view);
    EXPECT_EQ(out.frame, in.frame);
    EXPECT_EQ(out.revision, in.revision);
    EXPECT_EQ(out.width, in.width);
    EXPECT_EQ(out.height, in.height);
    EXPECT_EQ(out.time, in.time);
    EXPECT_EQ(out.wait_ms, in.wait_ms);
    EXPECT_EQ(out.extract_ms, in.extract_ms);
    EXPECT_EQ(out.draw_ms, in.draw_ms);
    EXPECT_EQ(out.encode_ms, in.encode_ms);
    EXPECT_EQ(out.triangles, in.triangles);
    EXPECT_EQ(out.payload_bytes, in.payload_bytes);
    EXPECT_EQ(out.whole_bytes, in.whole_bytes);
    EXPECT_EQ(out.piece_offset, in.piece_offset);
}

TEST(FrameHeader, PiecesCoverTheWholeAndShareItsFlags) {
    FrameHeader whole = sample();
    whole.flags = first_of_frame | last_of_frame | still;
    whole.piece_offset = 0;
    whole.payload_bytes = whole.whole_bytes = 1000;
    const auto piece = [&](std::uint32_t offset, std::uint32_t most) {
        const FrameHeader one = piece_of(whole, offset, most);
        return std::array<std::uint32_t, 3>{one.piece_offset, one.payload_bytes, one.flags};
    };
    using Piece = std::array<std::uint32_t, 3>;
    EXPECT_EQ(piece(0, 400), (Piece{0, 400, first_of_frame | still}));
    EXPECT_EQ(piece(400, 400), (Piece{400, 400, still}));
    EXPECT_EQ(piece(800, 400), (Piece{800, 200, last_of_frame | still}));
    EXPECT_EQ(piece(0, 1000), (Piece{0, 1000, first_of_frame | last_of_frame | still}));
    EXPECT_EQ(piece_of(whole, 400, 400).whole_bytes, 1000U);
}

TEST(FrameHeader, APictureComesBackFromItsPieces) {
    for (const Picture& picture : pictures()) {
        Bytes file;
        encode_png(picture.width, picture.height, picture.rgb, file);
        FrameHeader whole = sample();
        whole.piece_offset = 0;
        whole.payload_bytes = whole.whole_bytes = static_cast<std::uint32_t>(file.size());
        std::vector<Bytes> messages;
        for (std::uint32_t sent = 0; sent < file.size();) {
            const FrameHeader piece = piece_of(whole, sent, 1000);
            messages.push_back(message_of(piece));
            std::copy_n(file.begin() + sent, piece.payload_bytes, messages.back().begin() + frame_header_bytes);
            sent += piece.payload_bytes;
        }
        EXPECT_EQ(decoded_png(joined(messages), picture.width, picture.height), picture.rgb) << picture.name;
    }
}

TEST(FrameHeader, RefusesMalformedMessages) {
    struct Row {
        const char* name;
        std::function<void(Bytes&)> spoil;
        const char* error;
    };
    const std::vector<Row> rows{
        {"empty", [](Bytes& b) { b.clear(); }, "has 0 bytes"},
        {"cut", [](Bytes& b) { b.resize(79); }, "has 79 bytes"},
        {"magic", [](Bytes& b) { b[3] = 'l'; }, "does not begin with 'CIEL'"},
        {"version 0", [](Bytes& b) { b[4] = 0; }, "version 0"},
        {"version 1", [](Bytes& b) { b[4] = 1; }, "version 1"},
        {"kind 0", [](Bytes& b) { b[5] = 0; }, "kind 0"},
        {"kind 3", [](Bytes& b) { b[5] = 3; }, "kind 3"},
        {"flags", [](Bytes& b) { b[7] = 0x80; }, "unknown flags"},
        {"payload cut", [](Bytes& b) { b.pop_back(); }, "announces 2 bytes"},
        {"payload too long", [](Bytes& b) { b.push_back(0); }, "and has 3"},
        {"piece behind the whole", [](Bytes& b) { b[68] = 8; },
         "has 2 bytes at offset 8, but the whole frame has only 9"},
        {"offset 4 GiB", [](Bytes& b) { b[68] = b[69] = b[70] = b[71] = 0xff; }, "at offset 4294967295"},
        {"payload 4 GiB", [](Bytes& b) { b[60] = b[61] = b[62] = b[63] = 0xff; }, "announces 4294967295"},
    };
    for (const Row& row : rows) {
        Bytes bytes = message_of(sample());
        row.spoil(bytes);
        EXPECT_THAT([&] { static_cast<void>(read_frame_header(bytes)); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr(row.error)))
            << row.name;
    }
}

} // namespace
} // namespace server::wire
