#include "gateway/send_queue.hpp"

#include "ciel/types.hpp"
#include "wire/frame_header.hpp"

#include <gtest/gtest.h>

namespace server::gateway {
using namespace ciel;
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
std::vector<std::uint8_t> bytes_of(const SendQueue::Message& message) {
    std::vector<std::uint8_t> bytes(message.header.begin(), message.header.end());
    bytes.insert(bytes.end(), message.payload.begin(), message.payload.end());
    return bytes;
}

wire::FrameHeader header_of(const SendQueue::Message& message) { return wire::read_frame_header(bytes_of(message)); }

// Empties the send queue. Returns "text" or "view.frame" for each message, in order of sending.
std::vector<std::string> drained(SendQueue& send_queue) {
    std::vector<std::string> out;
    while (const auto next = send_queue.pop()) {
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

TEST(SendQueue, TextsGoFirstAndKeepTheirOrder) {
    SendQueue send_queue(2000, memory, [] {});
    send_queue.push_text("a");
    send_queue.push_frame(image(1, 1));
    send_queue.push_text("b");
    send_queue.push_frame(image(2, 1));
    EXPECT_EQ(drained(send_queue), (Order{"a", "b", "1.1", "2.1"}));
    EXPECT_EQ(send_queue.dropped_frames(), 0U);
    EXPECT_FALSE(send_queue.pop());
}

TEST(SendQueue, OfEachViewOnlyTheNewestFrameWaits) {
    SendQueue send_queue(2000, memory, [] {});
    for (std::uint32_t frame = 1; frame <= 100; ++frame) {
        send_queue.push_frame(image(1, frame));
        send_queue.push_frame(image(2, frame));
    }
    EXPECT_EQ(drained(send_queue), (Order{"1.100", "2.100"}));
    EXPECT_EQ(send_queue.dropped_frames(), 198U);
}

TEST(SendQueue, ReplacesWholeFramesOfBatches) {
    SendQueue send_queue(2000, memory, [] {});
    send_queue.push_frame(batch(1, 1, true, false));
    EXPECT_TRUE(send_queue.pop()); // this frame is being sent when the next one is made
    send_queue.push_frame(batch(1, 1, false, false));
    send_queue.push_frame(batch(1, 1, false, true));
    send_queue.push_frame(batch(2, 7, true, true));
    send_queue.push_frame(batch(1, 2, true, false));
    send_queue.push_frame(batch(1, 2, false, true));
    EXPECT_EQ(drained(send_queue), (Order{"2.7", "1.2", "1.2"}));
    EXPECT_EQ(send_queue.dropped_frames(), 2U);
}

TEST(SendQueue, FramesLeaveInPiecesThatMakeTheWhole) {
    SendQueue send_queue(2000, memory, [] {});
    const std::uint32_t payload = 3 * piece_bytes + 5;
    const FrameBytes whole = message(wire::FrameKind::image, 1, 1, wire::first_of_frame | wire::last_of_frame, payload);
    send_queue.push_frame(whole);
    std::vector<std::uint8_t> joined;
    std::vector<std::uint16_t> flags;
    while (const auto next = send_queue.pop()) {
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
    SendQueue send_queue(2000, memory, [] {});
    send_queue.push_frame(frame);
    std::vector<std::uint32_t> lengths;
    while (const auto next = send_queue.pop()) lengths.push_back(header_of(*next).payload_bytes);
    return lengths;
}

TEST(SendQueue, AFrameBeginsWithAShortPieceWhereTheRestMeasuresTheLine) {
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

TEST(SendQueue, ATextGoesBetweenThePiecesOfAFrame) {
    SendQueue send_queue(2000, memory, [] {});
    send_queue.push_frame(message(wire::FrameKind::geometry, 1, 1, wire::first_of_frame, 2 * piece_bytes));
    send_queue.push_frame(message(wire::FrameKind::geometry, 1, 1, wire::last_of_frame, 2 * piece_bytes));
    EXPECT_TRUE(send_queue.pop()->frame);
    send_queue.push_text("answer");
    EXPECT_EQ(drained(send_queue), (Order{"answer", "1.1", "1.1", "1.1", "1.1"}));
}

TEST(SendQueue, TheRestOfAFrameGivesWayToANewerOne) {
    SendQueue send_queue(2000, memory, [] {});
    send_queue.push_frame(
        message(wire::FrameKind::image, 1, 1, wire::first_of_frame | wire::last_of_frame, 5 * piece_bytes));
    EXPECT_TRUE(send_queue.pop());
    send_queue.push_frame(image(1, 2));
    EXPECT_EQ(drained(send_queue), (Order{"1.2"}));
}

TEST(SendQueue, OverflowsWhenAnswersAreNotRead) {
    SendQueue send_queue(20, memory, [] {});
    send_queue.push_text(std::string(100, 'x')); // a single answer may exceed the limit
    EXPECT_FALSE(send_queue.overflowed());
    send_queue.push_frame(image(1, 1));
    send_queue.push_text("y");
    EXPECT_TRUE(send_queue.overflowed());
    EXPECT_FALSE(send_queue.pop());
    send_queue.push_text("z");
    send_queue.push_frame(image(1, 2));
    EXPECT_FALSE(send_queue.pop());
}

TEST(SendQueue, ReadAnswersDoNotCount) {
    SendQueue send_queue(20, memory, [] {});
    for (int i = 0; i < 100; ++i) {
        send_queue.push_text(std::string(11, 'x'));
        EXPECT_TRUE(send_queue.pop());
    }
    EXPECT_FALSE(send_queue.overflowed());
}

TEST(SendQueue, TellsOfEveryPushUntilItIsClosed) {
    int pushes = 0;
    SendQueue send_queue(2000, memory, [&] { ++pushes; });
    send_queue.push_text("a");
    send_queue.push_frame(image(1, 1));
    EXPECT_EQ(pushes, 2);
    send_queue.close();
    EXPECT_FALSE(send_queue.pop());
    send_queue.push_text("b");
    send_queue.push_frame(image(1, 2));
    EXPECT_EQ(pushes, 2);
    EXPECT_FALSE(send_queue.pop());
}

TEST(SendQueue, RefusesWhatIsNoFrame) {
    SendQueue send_queue(2000, memory, [] {});
    EXPECT_THROW(send_queue.push_frame(std::make_shared<std::vector<std::uint8_t>>(10)), Error);
}

FrameBytes batch_of(std::uint32_t view, std::uint32_t frame, std::uint32_t bytes) {
    return message(wire::FrameKind::geometry, view, frame, wire::first_of_frame | wire::last_of_frame,
                   bytes - static_cast<std::uint32_t>(wire::frame_header_bytes));
}

TEST(SendQueue, EveryByteIsCountedUntilItIsSent) {
    {
        SendQueue send_queue(2000, memory, [] {});
        send_queue.push_text("four");
        send_queue.push_frame(batch_of(1, 1, 300));
        EXPECT_EQ(held(), 304U);
        send_queue.push_frame(batch_of(1, 2, 400));
        EXPECT_EQ(held(), 404U) << "it took the place of the first";
        EXPECT_TRUE(send_queue.pop());
        EXPECT_EQ(held(), 404U) << "on its way";
        EXPECT_FALSE(send_queue.sent());
        EXPECT_EQ(held(), 400U);
        send_queue.push_frame(batch_of(1, 3, 3 * piece_bytes));
        for (int piece = 0; piece < 4; ++piece) {
            EXPECT_TRUE(send_queue.pop());
            EXPECT_EQ(held(), 3 * piece_bytes) << "whole until its last piece is sent";
            EXPECT_FALSE(send_queue.sent());
        }
        EXPECT_EQ(held(), 0U);
        send_queue.push_text("closed");
    }
    EXPECT_EQ(held(), 0U);
}

TEST(SendQueue, HasRoomForOneFrameOfAnySizeOrForAsManyAsKeepTheirHalf) {
    SendQueue send_queue(2000, memory, [] {});
    EXPECT_TRUE(send_queue.has_room(5000));
    send_queue.push_frame(batch_of(1, 1, 600));
    EXPECT_TRUE(send_queue.has_room(400));
    EXPECT_FALSE(send_queue.has_room(401));
    EXPECT_TRUE(send_queue.pop());
    EXPECT_FALSE(send_queue.has_room(401)) << "on its way, not sent";
    EXPECT_TRUE(send_queue.sent()) << "who had no room is told";
    EXPECT_FALSE(send_queue.sent()) << "once";
    EXPECT_TRUE(send_queue.has_room(5000));
}

} // namespace
} // namespace server::gateway
