#include "gateway/outbox.hpp"

#include "ciel/types.hpp"
#include "wire/frame_header.hpp"

#include <gtest/gtest.h>

namespace ciel::gateway {
namespace {

FrameBytes message(wire::FrameKind kind, std::uint32_t view, std::uint32_t frame, std::uint16_t flags) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(wire::frame_header_bytes);
    wire::FrameHeader header;
    header.kind = kind;
    header.view = view;
    header.frame = frame;
    header.flags = flags;
    wire::write_frame_header(header, std::span<std::uint8_t, wire::frame_header_bytes>(bytes->data(), bytes->size()));
    return bytes;
}

FrameBytes image(std::uint32_t view, std::uint32_t frame) {
    return message(wire::FrameKind::image, view, frame, wire::first_of_frame | wire::last_of_frame);
}

FrameBytes batch(std::uint32_t view, std::uint32_t frame, bool first, bool last) {
    return message(wire::FrameKind::geometry, view, frame,
                   static_cast<std::uint16_t>((first ? wire::first_of_frame : 0) | (last ? wire::last_of_frame : 0)));
}

// "text" for texts, "view.frame" for frames, in the order they would be sent.
std::vector<std::string> drained(Outbox& outbox) {
    std::vector<std::string> out;
    while (const auto next = outbox.pop()) {
        if (!next->frame) {
            out.push_back(next->text);
            continue;
        }
        const auto header = wire::read_frame_header(*next->frame);
        out.push_back(std::to_string(header.view) + "." + std::to_string(header.frame));
    }
    return out;
}

using Order = std::vector<std::string>;

TEST(Outbox, KeepsTheOrderOfWhatItKeeps) {
    Outbox outbox(1000, [] {});
    outbox.push_text("a");
    outbox.push_frame(image(1, 1));
    outbox.push_text("b");
    outbox.push_frame(image(2, 1));
    EXPECT_EQ(drained(outbox), (Order{"a", "1.1", "b", "2.1"}));
    EXPECT_EQ(outbox.dropped_frames(), 0U);
    EXPECT_FALSE(outbox.pop());
}

TEST(Outbox, OfEachViewOnlyTheNewestFrameWaits) {
    Outbox outbox(1000, [] {});
    for (std::uint32_t frame = 1; frame <= 100; ++frame) {
        outbox.push_frame(image(1, frame));
        outbox.push_frame(image(2, frame));
    }
    EXPECT_EQ(drained(outbox), (Order{"1.100", "2.100"}));
    EXPECT_EQ(outbox.dropped_frames(), 198U);
}

TEST(Outbox, ReplacesWholeFramesOfBatches) {
    Outbox outbox(1000, [] {});
    outbox.push_frame(batch(1, 1, true, false));
    EXPECT_TRUE(outbox.pop()); // on its way when the next frame is made
    outbox.push_frame(batch(1, 1, false, false));
    outbox.push_frame(batch(1, 1, false, true));
    outbox.push_frame(batch(2, 7, true, true));
    outbox.push_frame(batch(1, 2, true, false));
    outbox.push_frame(batch(1, 2, false, true));
    EXPECT_EQ(drained(outbox), (Order{"2.7", "1.2", "1.2"}));
    EXPECT_EQ(outbox.dropped_frames(), 2U);
}

TEST(Outbox, OverflowsWhenAnswersAreNotRead) {
    Outbox outbox(10, [] {});
    outbox.push_text(std::string(100, 'x')); // one answer may be large
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
    Outbox outbox(10, [] {});
    for (int i = 0; i < 100; ++i) {
        outbox.push_text(std::string(11, 'x'));
        EXPECT_TRUE(outbox.pop());
    }
    EXPECT_FALSE(outbox.overflowed());
}

TEST(Outbox, TellsOfEveryPushUntilItIsClosed) {
    int pushes = 0;
    Outbox outbox(1000, [&] { ++pushes; });
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
    Outbox outbox(1000, [] {});
    EXPECT_THROW(outbox.push_frame(std::make_shared<std::vector<std::uint8_t>>(10)), Error);
}

} // namespace
} // namespace ciel::gateway
