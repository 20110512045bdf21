#include "gateway/outbox.hpp"

#include "ciel/types.hpp"
#include "wire/frame_header.hpp"

#include <gtest/gtest.h>

namespace ciel::gateway {
namespace {

FrameBytes message(wire::FrameKind kind, std::uint32_t view, std::uint32_t frame, std::uint16_t flags,
                   std::uint32_t payload = 0) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(wire::frame_header_bytes);
    wire::FrameHeader header;
    header.kind = kind;
    header.view = view;
    header.frame = frame;
    header.flags = flags;
    header.payload_bytes = header.whole_bytes = payload;
    wire::write_frame_header(header, std::span<std::uint8_t, wire::frame_header_bytes>(bytes->data(), bytes->size()));
    for (std::uint32_t i = 0; i < payload; ++i) bytes->push_back(static_cast<std::uint8_t>(i * 2654435761U >> 24));
    return bytes;
}

FrameBytes image(std::uint32_t view, std::uint32_t frame) {
    return message(wire::FrameKind::image, view, frame, wire::first_of_frame | wire::last_of_frame);
}

FrameBytes batch(std::uint32_t view, std::uint32_t frame, bool first, bool last) {
    return message(wire::FrameKind::geometry, view, frame,
                   static_cast<std::uint16_t>((first ? wire::first_of_frame : 0) | (last ? wire::last_of_frame : 0)));
}

// The bytes as they are sent.
std::vector<std::uint8_t> bytes_of(const Outbox::Message& message) {
    std::vector<std::uint8_t> bytes(message.header.begin(), message.header.end());
    bytes.insert(bytes.end(), message.payload.begin(), message.payload.end());
    return bytes;
}

wire::FrameHeader header_of(const Outbox::Message& message) { return wire::read_frame_header(bytes_of(message)); }

// Empties the outbox. Returns "text" or "view.frame" for each message, in order of sending.
std::vector<std::string> drained(Outbox& outbox) {
    std::vector<std::string> out;
    while (const auto next = outbox.pop()) {
        if (!next->frame) {
            out.push_back(next->text);
            continue;
        }
        const auto header = header_of(*next);
        out.push_back(std::to_string(header.view) + "." + std::to_string(header.frame));
    }
    return out;
}

limits::Memory memory(
    1 << 20, [] { return 0; }, [] {});
std::uint64_t held() { return memory.bytes(limits::Held::unsent); }

using Order = std::vector<std::string>;

TEST(Outbox, TextsGoFirstAndKeepTheirOrder) {
    Outbox outbox(2000, memory, [] {});
    outbox.push_text("a");
    outbox.push_frame(image(1, 1));
    outbox.push_text("b");
    outbox.push_frame(image(2, 1));
    EXPECT_EQ(drained(outbox), (Order{"a", "b", "1.1", "2.1"}));
    EXPECT_EQ(outbox.dropped_frames(), 0U);
    EXPECT_FALSE(outbox.pop());
}

TEST(Outbox, OfEachViewOnlyTheNewestFrameWaits) {
    Outbox outbox(2000, memory, [] {});
    for (std::uint32_t frame = 1; frame <= 100; ++frame) {
        outbox.push_frame(image(1, frame));
        outbox.push_frame(image(2, frame));
    }
    EXPECT_EQ(drained(outbox), (Order{"1.100", "2.100"}));
    EXPECT_EQ(outbox.dropped_frames(), 198U);
}

TEST(Outbox, ReplacesWholeFramesOfBatches) {
    Outbox outbox(2000, memory, [] {});
    outbox.push_frame(batch(1, 1, true, false));
    EXPECT_TRUE(outbox.pop()); // this frame is being sent when the next one is made
    outbox.push_frame(batch(1, 1, false, false));
    outbox.push_frame(batch(1, 1, false, true));
    outbox.push_frame(batch(2, 7, true, true));
    outbox.push_frame(batch(1, 2, true, false));
    outbox.push_frame(batch(1, 2, false, true));
    EXPECT_EQ(drained(outbox), (Order{"2.7", "1.2", "1.2"}));
    EXPECT_EQ(outbox.dropped_frames(), 2U);
}

TEST(Outbox, FramesLeaveInPiecesThatMakeTheWhole) {
    Outbox outbox(2000, memory, [] {});
    const std::uint32_t payload = 3 * piece_bytes + 5;
    const FrameBytes whole = message(wire::FrameKind::image, 1, 1, wire::first_of_frame | wire::last_of_frame, payload);
    outbox.push_frame(whole);
    std::vector<std::uint8_t> joined;
    std::vector<std::uint16_t> flags;
    while (const auto next = outbox.pop()) {
        const auto header = header_of(*next);
        EXPECT_LE(bytes_of(*next).size(), std::size_t{512} << 10);
        EXPECT_EQ(header.piece_offset, joined.size());
        EXPECT_EQ(header.whole_bytes, payload);
        joined.insert(joined.end(), next->payload.begin(), next->payload.end());
        flags.push_back(header.flags);
    }
    EXPECT_TRUE(std::equal(joined.begin(), joined.end(), whole->begin() + wire::frame_header_bytes, whole->end()));
    EXPECT_EQ(flags, (std::vector<std::uint16_t>{wire::first_of_frame, 0, 0, wire::last_of_frame}));
}

std::vector<std::uint32_t> piece_lengths(const FrameBytes& frame) {
    Outbox outbox(2000, memory, [] {});
    outbox.push_frame(frame);
    std::vector<std::uint32_t> lengths;
    while (const auto next = outbox.pop()) lengths.push_back(header_of(*next).payload_bytes);
    return lengths;
}

TEST(Outbox, AFrameBeginsWithAShortPieceWhereTheRestMeasuresTheLine) {
    using Lengths = std::vector<std::uint32_t>;
    const auto of = [](wire::FrameKind kind, std::uint16_t flags, std::uint32_t payload) {
        return piece_lengths(message(kind, 1, 1, flags, payload));
    };
    const std::uint16_t whole = wire::first_of_frame | wire::last_of_frame;
    EXPECT_EQ(of(wire::FrameKind::image, whole, measuring_bytes - 1), Lengths{measuring_bytes - 1});
    EXPECT_EQ(of(wire::FrameKind::image, whole, measuring_bytes), (Lengths{first_piece_bytes, 32 << 10}));
    EXPECT_EQ(of(wire::FrameKind::geometry, wire::first_of_frame, 100'000),
              (Lengths{first_piece_bytes, piece_bytes, 100'000 - first_piece_bytes - piece_bytes}));
    EXPECT_EQ(of(wire::FrameKind::geometry, 0, 100'000), (Lengths{piece_bytes, 100'000 - piece_bytes}))
        << "the batches behind the first";
}

TEST(Outbox, ATextGoesBetweenThePiecesOfAFrame) {
    Outbox outbox(2000, memory, [] {});
    outbox.push_frame(message(wire::FrameKind::geometry, 1, 1, wire::first_of_frame, 2 * piece_bytes));
    outbox.push_frame(message(wire::FrameKind::geometry, 1, 1, wire::last_of_frame, 2 * piece_bytes));
    EXPECT_TRUE(outbox.pop()->frame);
    outbox.push_text("answer");
    EXPECT_EQ(drained(outbox), (Order{"answer", "1.1", "1.1", "1.1", "1.1"}));
}

TEST(Outbox, TheRestOfAFrameGivesWayToANewerOne) {
    Outbox outbox(2000, memory, [] {});
    outbox.push_frame(
        message(wire::FrameKind::image, 1, 1, wire::first_of_frame | wire::last_of_frame, 5 * piece_bytes));
    EXPECT_TRUE(outbox.pop());
    outbox.push_frame(image(1, 2));
    EXPECT_EQ(drained(outbox), (Order{"1.2"}));
}

TEST(Outbox, OverflowsWhenAnswersAreNotRead) {
    Outbox outbox(20, memory, [] {});
    outbox.push_text(std::string(100, 'x')); // a single answer may exceed the limit
    EXPECT_FALSE(outbox.overflowed());
    outbox.push_frame(image(1, 1));
    outbox.push_text("y");
    EXPECT_TRUE(outbox.overflowed());
    EXPECT_FALSE(outbox.pop());
    outbox.push_text("z");
    outbox.push_frame(image(1, 2));
    EXPECT_FALSE(outbox.pop());
}

TEST(Outbox, ReadAnswersDoNotCount) {
    Outbox outbox(20, memory, [] {});
    for (int i = 0; i < 100; ++i) {
        outbox.push_text(std::string(11, 'x'));
        EXPECT_TRUE(outbox.pop());
    }
    EXPECT_FALSE(outbox.overflowed());
}

TEST(Outbox, TellsOfEveryPushUntilItIsClosed) {
    int pushes = 0;
    Outbox outbox(2000, memory, [&] { ++pushes; });
    outbox.push_text("a");
    outbox.push_frame(image(1, 1));
    EXPECT_EQ(pushes, 2);
    outbox.close();
    EXPECT_FALSE(outbox.pop());
    outbox.push_text("b");
    outbox.push_frame(image(1, 2));
    EXPECT_EQ(pushes, 2);
    EXPECT_FALSE(outbox.pop());
}

TEST(Outbox, RefusesWhatIsNoFrame) {
    Outbox outbox(2000, memory, [] {});
    EXPECT_THROW(outbox.push_frame(std::make_shared<std::vector<std::uint8_t>>(10)), Error);
}

FrameBytes batch_of(std::uint32_t view, std::uint32_t frame, std::uint32_t bytes) {
    return message(wire::FrameKind::geometry, view, frame, wire::first_of_frame | wire::last_of_frame,
                   bytes - static_cast<std::uint32_t>(wire::frame_header_bytes));
}

TEST(Outbox, EveryByteIsCountedUntilItIsSent) {
    {
        Outbox outbox(2000, memory, [] {});
        outbox.push_text("four");
        outbox.push_frame(batch_of(1, 1, 300));
        EXPECT_EQ(held(), 304U);
        outbox.push_frame(batch_of(1, 2, 400));
        EXPECT_EQ(held(), 404U) << "it took the place of the first";
        EXPECT_TRUE(outbox.pop());
        EXPECT_EQ(held(), 404U) << "on its way";
        EXPECT_FALSE(outbox.sent());
        EXPECT_EQ(held(), 400U);
        outbox.push_frame(batch_of(1, 3, 3 * piece_bytes));
        for (int piece = 0; piece < 4; ++piece) {
            EXPECT_TRUE(outbox.pop());
            EXPECT_EQ(held(), 3 * piece_bytes) << "whole until its last piece is sent";
            EXPECT_FALSE(outbox.sent());
        }
        EXPECT_EQ(held(), 0U);
        outbox.push_text("closed");
    }
    EXPECT_EQ(held(), 0U);
}

TEST(Outbox, HasRoomForOneFrameOfAnySizeOrForAsManyAsKeepTheirHalf) {
    Outbox outbox(2000, memory, [] {});
    EXPECT_TRUE(outbox.has_room(5000));
    outbox.push_frame(batch_of(1, 1, 600));
    EXPECT_TRUE(outbox.has_room(400));
    EXPECT_FALSE(outbox.has_room(401));
    EXPECT_TRUE(outbox.pop());
    EXPECT_FALSE(outbox.has_room(401)) << "on its way, not sent";
    EXPECT_TRUE(outbox.sent()) << "who had no room is told";
    EXPECT_FALSE(outbox.sent()) << "once";
    EXPECT_TRUE(outbox.has_room(5000));
}

} // namespace
} // namespace ciel::gateway
