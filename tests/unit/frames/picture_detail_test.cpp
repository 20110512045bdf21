#include "frames/picture_detail.hpp"

#include <gtest/gtest.h>

namespace server::frames {
namespace {

using wire::MovingCodec;
using Detail = PictureDetail::Detail;
constexpr double mbit = 1e6 / 8, making = 0.066;

// Encoded size at this detail. `bytes`: size at scale 1 and quality 80. The size is proportional to quality.
std::size_t bytes_of(Detail detail, double bytes) {
    return static_cast<std::size_t>(bytes * detail.scale * detail.scale * detail.quality / 80);
}

void send(PictureDetail& detail, wire::MovingCodec codec, int pictures, double bytes, double rate) {
    for (int i = 0; i < pictures; ++i) detail.sent(codec, bytes_of(detail.of(codec), bytes), making, rate);
}

TEST(PictureDetail, IsAllOfItWhereNothingSaysThatTheLineIsSlow) {
    PictureDetail detail;
    send(detail, wire::MovingCodec::jpeg, 100, 1e6, 0);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg), (Detail{80, 1}));
    EXPECT_EQ(detail.of(wire::MovingCodec::png), (Detail{80, 1}));
}

TEST(PictureDetail, QualityGoesBeforeSizeAndNoFurtherThanTheLineNeeds) {
    PictureDetail detail;
    send(detail, wire::MovingCodec::jpeg, 100, 60'000, 10 * mbit);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg), (Detail{80, 1})) << "60 kB fit into 66 ms";
    send(detail, wire::MovingCodec::jpeg, 100, 95'000, 10 * mbit);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg), (Detail{60, 1}));
    send(detail, wire::MovingCodec::jpeg, 100, 400'000, 10 * mbit);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg).quality, 40);
    EXPECT_LT(detail.of(wire::MovingCodec::jpeg).scale, 1);
}

TEST(PictureDetail, PicturesWithoutLossBecomeSmaller) {
    PictureDetail detail;
    send(detail, wire::MovingCodec::png, 100, 250'000, 10 * mbit);
    EXPECT_EQ(detail.of(wire::MovingCodec::png), (Detail{80, 0.5}));
    EXPECT_LE(bytes_of(detail.of(wire::MovingCodec::png), 250'000), 10 * mbit * making);
}

TEST(PictureDetail, LetsAFastServerSendThirtyPicturesASecond) {
    PictureDetail detail;
    for (int i = 0; i < 100; ++i)
        detail.sent(MovingCodec::png, bytes_of(detail.of(MovingCodec::png), 50'000), 0.02, 10 * mbit);
    EXPECT_EQ(detail.of(MovingCodec::png), (Detail{80, 0.7}));
    for (int i = 0; i < 100; ++i)
        detail.sent(MovingCodec::png, bytes_of(detail.of(MovingCodec::png), 30'000), 0.02, 10 * mbit);
    EXPECT_EQ(detail.of(MovingCodec::png), (Detail{80, 1}));
}

TEST(PictureDetail, StaysWhereItIsWhereTheNextFinerWouldNotFit) {
    PictureDetail detail;
    send(detail, wire::MovingCodec::png, 20, 250'000, 10 * mbit);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(detail.of(wire::MovingCodec::png), (Detail{80, 0.5})) << i;
        send(detail, wire::MovingCodec::png, 1, 250'000, 10 * mbit);
    }
}

TEST(PictureDetail, StaysWhereItIsAtAnySize) {
    for (const MovingCodec codec : {MovingCodec::png, MovingCodec::jpeg})
        for (double bytes = 20'000; bytes < 1e6; bytes *= 1.005) {
            PictureDetail detail;
            send(detail, codec, 200, bytes, 10 * mbit);
            const Detail found = detail.of(codec);
            for (int i = 0; i < 40; ++i) {
                send(detail, codec, 1, bytes, 10 * mbit);
                ASSERT_EQ(detail.of(codec), found) << bytes << ' ' << i;
            }
        }
}

TEST(PictureDetail, ComesBackOnAFasterLine) {
    PictureDetail detail;
    send(detail, wire::MovingCodec::jpeg, 100, 400'000, 2 * mbit);
    EXPECT_LT(detail.of(wire::MovingCodec::jpeg).scale, 0.5);
    send(detail, wire::MovingCodec::jpeg, 100, 400'000, 100 * mbit);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg), (Detail{80, 1}));
    send(detail, wire::MovingCodec::jpeg, 100, 400'000, 2 * mbit);
    send(detail, wire::MovingCodec::jpeg, 100, 400'000, 0);
    EXPECT_EQ(detail.of(wire::MovingCodec::jpeg), (Detail{80, 1}));
}

} // namespace
} // namespace server::frames
