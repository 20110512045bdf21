// CongestionWindow on a simulated line with latency and a limited rate, which may buffer any number of frames.
#include "frames/congestion_window.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace server::frames {
namespace {

struct Line {
    double round_trip = 0; // seconds
    double rate = 1e9;     // bytes per second
    double present = 0.01; // seconds from the arrival of a frame to its display
    double jitter = 0;     // additional seconds for every seventh frame
    double busy = 0;       // upper limit of random additional seconds for each frame
    double animation = 0;  // seconds between the animation frames in which the browser shows what has arrived
    double swing = 0;      // period in seconds in which the frame size goes from full to a quarter and back
    bool adapts = false;   // whether frames have twice the size until the window has measured the rate
    double small = 0;      // seconds at the beginning in which frames have a fiftieth of the size
    std::uint32_t seed = 1;
    bool acknowledges = true;
};

struct Outcome {
    std::size_t frames = 0;          // frames sent after the first seconds, in which the window adapts
    std::size_t most_on_the_way = 0; // largest number of frames in flight
    std::size_t most_queued = 0;     // largest number of bytes queued before a new frame, after the first seconds
    double rate = 0;                 // bytes per second that the window has measured
};

// Simulates a server that needs `making` seconds per frame of `bytes`, with a scene that changes all the time.
// `settled`: number of seconds in which the window adapts.
Outcome run(const Line& line, double making, std::size_t bytes, double seconds = 9, double settled = 3) {
    CongestionWindow window(2);
    Outcome result;
    const auto at = [](double time) {
        return CongestionWindow::Time(
            std::chrono::duration_cast<CongestionWindow::Time::duration>(CongestionWindow::Seconds(time)));
    };
    std::map<double, std::uint32_t> acknowledgements;
    double now = 0, free = 0, shown = 0;
    std::uint32_t frame = 0;
    std::minstd_rand random(line.seed);
    const auto go_on_until = [&](double time) {
        now = std::max(now, time);
        for (; !acknowledgements.empty() && acknowledgements.begin()->first <= now;
             acknowledgements.erase(acknowledgements.begin()))
            window.acknowledged(acknowledgements.begin()->second, at(acknowledgements.begin()->first));
    };
    while (now < settled + seconds) {
        if (!window.has_room()) {
            window.held_back();
            if (acknowledgements.empty()) break;
            go_on_until(acknowledgements.begin()->first);
            continue;
        }
        go_on_until(now + making);
        if (now > settled) {
            const auto queued = static_cast<std::size_t>(std::max(0.0, free - now) * line.rate);
            result.most_queued = std::max(result.most_queued, queued);
            ++result.frames;
        }
        const double part = line.swing > 0 ? std::abs(2 * std::fmod(now / line.swing, 1) - 1) : 1;
        double times = line.adapts && window.rate() == 0 ? 2 : 0.25 + 0.75 * part;
        if (now < line.small) times = 0.02;
        const auto size = static_cast<std::size_t>(times * static_cast<double>(bytes));
        window.sent(++frame, size, false, at(now));
        result.most_on_the_way = std::max(result.most_on_the_way, window.frames_on_the_way());
        free = std::max(free, now) + static_cast<double>(size) / line.rate;
        shown = std::max(shown, free + line.round_trip / 2 + line.present + (frame % 7 == 0 ? line.jitter : 0) +
                                    line.busy * static_cast<double>(random()) / std::minstd_rand::max());
        if (line.animation > 0) shown = std::ceil(shown / line.animation) * line.animation;
        if (line.acknowledges) acknowledgements[shown + line.round_trip / 2] = frame;
    }
    result.rate = window.rate();
    return result;
}

constexpr double mbit = 1e6 / 8;
constexpr std::uint32_t runs = 40; // of a line with random times, each with another seed

TEST(CongestionWindow, ALongLineShowsAsManyFramesAsAShortOne) {
    for (const double round_trip : {0.0, 0.05, 0.2, 0.5}) {
        const Outcome far = run({round_trip, 10 * mbit}, 0.066, 40'000);
        EXPECT_GE(static_cast<double>(far.frames), 0.9 * 9 / 0.066) << round_trip;
        EXPECT_LE(far.most_queued, 0U) << round_trip << ": the server is slower than the line";
    }
}

TEST(CongestionWindow, AShortLineHasFewOnTheWay) {
    EXPECT_LE(run({0, 100 * mbit}, 0.05, 40'000).most_on_the_way, 2U);
    EXPECT_LE(run({0.2, 10 * mbit}, 0.066, 40'000).most_on_the_way, 6U);
}

TEST(CongestionWindow, AFullLineDoesNotQueueAndIsMeasured) {
    for (const double round_trip : {0.02, 0.05, 0.2})
        for (const std::size_t bytes : {40'000U, 200'000U}) {
            const Line line{round_trip, 10 * mbit};
            const Outcome full = run(line, 0.02, bytes);
            EXPECT_GE(static_cast<double>(full.frames * bytes), 0.75 * 9 * line.rate) << round_trip << ' ' << bytes;
            EXPECT_LE(full.most_queued, 0.05 * line.rate + static_cast<double>(bytes)) << round_trip << ' ' << bytes;
            EXPECT_NEAR(full.rate / line.rate, 1, 0.25) << round_trip << ' ' << bytes;
        }
}

TEST(CongestionWindow, FramesThatAdaptLeaveNoQueue) {
    for (const double round_trip : {0.02, 0.05, 0.2})
        for (const double busy : {0.0, 0.02}) {
            Line line{round_trip, 10 * mbit, 0.01, 0, busy};
            line.adapts = true;
            const Outcome small = run(line, 0.033, 30'000, 9, 1.5);
            EXPECT_LE(static_cast<double>(small.most_queued), 0.05 * line.rate) << round_trip << ' ' << busy;
            EXPECT_GE(static_cast<double>(small.frames), 0.9 * 9 / 0.033) << round_trip << ' ' << busy;
        }
}

// The first large frame is very late. The small frame before it did not fill the line, so its rate says nothing.
TEST(CongestionWindow, SmallFramesBeforeLargeOnesDoNotMakeTheLineSlow) {
    Line line{0.05, 10 * mbit};
    line.small = 0.5;
    const Outcome large = run(line, 0.033, 300'000);
    EXPECT_NEAR(large.rate / line.rate, 1, 0.25);
}

TEST(CongestionWindow, AcknowledgementsInBurstsDoNotMakeTheLineFaster) {
    for (const double round_trip : {0.0, 0.02, 0.05, 0.2})
        for (const std::size_t bytes : {50'000U, 60'000U, 70'000U, 100'000U}) {
            Line line{round_trip, 10 * mbit, 0.01, 0, 0.02};
            line.animation = 1.0 / 30;
            const Outcome full = run(line, 0.02, bytes);
            EXPECT_NEAR(full.rate / line.rate, 1, 0.25) << round_trip << ' ' << bytes;
        }
}

TEST(CongestionWindow, ABrowserThatStumblesCostsFewFrames) {
    const Outcome far = run({0.2, 10 * mbit, 0.01, 0.04}, 0.066, 40'000);
    EXPECT_GE(static_cast<double>(far.frames), 0.9 * 9 / 0.066);
}

TEST(CongestionWindow, ABusyBrowserIsNoFullLine) {
    const struct {
        double making, round_trip, busy;
    } cases[]{{0.066, 0.05, 0.06}, {0.066, 0.05, 0.12}, {0.066, 0.2, 0.06}, {0.033, 0.05, 0.06}, {0.033, 0.2, 0.06}};
    for (const auto& [making, round_trip, busy] : cases) {
        double frames = 0;
        std::uint32_t too_low = 0;
        for (std::uint32_t run_number = 1; run_number <= runs; ++run_number) {
            Line line{round_trip, 100 * mbit, 0.01, 0, busy};
            line.seed = run_number * 7919;
            const Outcome far = run(line, making, 30'000, 30);
            frames += static_cast<double>(far.frames) / runs;
            too_low += far.rate > 0 && far.rate < 0.9 * 30'000 / making ? 1U : 0U;
        }
        EXPECT_GE(frames, 0.95 * 30 / making) << making << ' ' << round_trip << ' ' << busy;
        EXPECT_LE(too_low, 1U) << making << ' ' << round_trip << ' ' << busy << ": quality would go";
    }
}

TEST(CongestionWindow, FramesThatGrowForABusyBrowserAreNoFullLine) {
    for (const double round_trip : {0.05, 0.2})
        for (const double busy : {0.03, 0.06, 0.09}) {
            double frames = 0;
            for (std::uint32_t run_number = 1; run_number <= runs; ++run_number) {
                Line line{round_trip, 10 * mbit, 0.01, 0, busy, 0, 4};
                line.seed = run_number * 7919;
                frames += static_cast<double>(run(line, 0.05, 45'000, 60).frames) / runs;
            }
            EXPECT_GE(frames, 0.85 * 60 / 0.05) << round_trip << ' ' << busy;
        }
}

TEST(CongestionWindow, FramesThatNeedSecondsGoOneByOne) {
    const Outcome polygons = run({0.2, 10 * mbit}, 0.1, 4'000'000, 60);
    EXPECT_LE(polygons.most_queued, 4'000'000U);
    EXPECT_GE(polygons.frames, 12U);
}

TEST(CongestionWindow, WithoutAcknowledgementsTwoFramesAreMade) {
    Line dead{0.05};
    dead.acknowledges = false;
    EXPECT_EQ(run(dead, 0.05, 40'000).most_on_the_way, 2U);
}

TEST(CongestionWindow, AClientThatStopsReadingCostsNoMoreThanALineful) {
    CongestionWindow window(2);
    CongestionWindow::Time now{};
    std::uint32_t frame = 0;
    for (int i = 0; i < 100; ++i) { // line with a round trip of 100 ms, so ten frames are in flight
        while (window.has_room() && window.frames_on_the_way() < 10) window.sent(++frame, 1000, false, now);
        window.held_back();
        now += std::chrono::milliseconds(10);
        if (frame > 9) window.acknowledged(frame - 9, now);
    }
    std::size_t more = 0;
    for (; window.has_room(); ++more) window.sent(++frame, 1000, false, now);
    EXPECT_LE(window.frames_on_the_way(), 64U);
    EXPECT_FALSE(window.has_room());
}

TEST(CongestionWindow, AStillDoesNotKeepTheHandWaiting) {
    CongestionWindow window(2);
    CongestionWindow::Time now{};
    window.sent(1, 40'000, false, now);
    window.acknowledged(1, now += std::chrono::milliseconds(200));
    window.sent(2, 800'000, true, now);
    EXPECT_TRUE(window.has_room());
    window.sent(3, 40'000, false, now);
    window.sent(4, 40'000, false, now);
    window.held_back();
    for (const std::uint32_t frame : {2U, 3U, 4U}) window.acknowledged(frame, now += std::chrono::milliseconds(800));
    EXPECT_EQ(window.rate(), 0) << "what is late behind a still is no sign of a queue";
    EXPECT_EQ(window.bytes_on_the_way(), 0U);
}

TEST(CongestionWindow, AcknowledgesAllBeforeAndIgnoresWhatWasNotSent) {
    CongestionWindow window(2);
    const CongestionWindow::Time start{};
    window.sent(1, 10, false, start);
    window.sent(2, 20, false, start);
    EXPECT_FALSE(window.has_room());
    EXPECT_FALSE(window.acknowledged(0, start + std::chrono::milliseconds(5)));
    EXPECT_EQ(window.bytes_on_the_way(), 30U);
    EXPECT_TRUE(window.acknowledged(2, start + std::chrono::milliseconds(20)));
    EXPECT_EQ(window.bytes_on_the_way(), 0U);
    EXPECT_TRUE(window.has_room());
    EXPECT_FALSE(window.acknowledged(1, start + std::chrono::milliseconds(30)));
}

} // namespace
} // namespace server::frames
