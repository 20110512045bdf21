// The turns of one view, by a clock that the tests move.
#include "engine/schedule/view_schedule.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>

namespace server::engine {
using namespace ciel::test;
namespace {

using namespace std::chrono_literals;

class ViewScheduleTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<Folder>();
        write_small_dataset(folder->path() / "box.ciel");
        loaded = std::make_shared<store::LoadedDataset>(store::Dataset::open(folder->path() / "box.ciel"),
                                                        std::size_t{1} << 20);
    }
    static void TearDownTestSuite() {
        loaded.reset();
        folder.reset();
    }
    static ViewSchedule::Version version(std::uint64_t revision) {
        scene::Scene scene;
        scene.dataset = "box";
        return std::make_shared<sessions::SceneVersion>(
            sessions::SceneVersion{revision, {}, scene::CheckedScene(scene, loaded), 0, {}, ""});
    }
    void offer(std::uint64_t revision) { schedule.offer(version(revision), now); }
    // Begins a frame; fails the test unless one is due.
    FrameTurn begin(bool still) {
        if (!schedule.begin(still, true, now)) throw std::runtime_error("no frame is due");
        return schedule.take(still, now);
    }
    // Makes the interactive frame of a revision, so that its still picture is wanted.
    void show(std::uint64_t revision) {
        offer(revision);
        schedule.made(begin(false), true, now);
    }
    void wait(std::chrono::milliseconds time) { now += time; }

    static std::unique_ptr<Folder> folder;
    static std::shared_ptr<store::LoadedDataset> loaded;
    ViewSchedule schedule;
    Time now = Time() + 1h;
};

std::unique_ptr<Folder> ViewScheduleTest::folder;
std::shared_ptr<store::LoadedDataset> ViewScheduleTest::loaded;

TEST_F(ViewScheduleTest, DrawsOnlyTheNewestScene) {
    offer(1);
    offer(3);
    offer(2); // late: another thread was faster
    EXPECT_EQ(begin(false).version->revision, 3U);
    EXPECT_FALSE(schedule.has_change());
}

TEST_F(ViewScheduleTest, MakesOneFrameAtATime) {
    offer(1);
    schedule.posted(false, true);
    EXPECT_FALSE(schedule.may_post()) << "a job is posted";
    const FrameTurn turn = begin(false);
    EXPECT_FALSE(schedule.may_post()) << "a frame is being made";
    offer(2);
    EXPECT_FALSE(schedule.begin(false, true, now));
    schedule.made(turn, true, now);
    EXPECT_TRUE(schedule.may_post());
    EXPECT_TRUE(schedule.has_change());
}

TEST_F(ViewScheduleTest, MakesNoFrameWithoutRoom) {
    offer(1);
    EXPECT_FALSE(schedule.begin(false, false, now));
    EXPECT_EQ(begin(false).version->revision, 1U) << "the scene is not lost";
}

TEST_F(ViewScheduleTest, AStillFollowsAfterAPause) {
    show(1);
    ASSERT_TRUE(schedule.lacks_still());
    EXPECT_EQ(schedule.still_due(), now + 150ms);
    EXPECT_FALSE(schedule.begin(true, true, now + 149ms));
    wait(100ms);
    schedule.acknowledged(now);
    EXPECT_FALSE(schedule.begin(true, true, now + 149ms)) << "the user may react to the frame";
    wait(150ms);
    const FrameTurn still = begin(true);
    EXPECT_EQ(still.version->revision, 1U);
    schedule.made(still, false, now);
    EXPECT_FALSE(schedule.lacks_still());
}

TEST_F(ViewScheduleTest, AStillWaitsForAPostedFrame) {
    show(1);
    schedule.posted(true, true);
    EXPECT_FALSE(schedule.lacks_still()) << "its job is posted";
    wait(150ms);
    schedule.posted(false, true);
    EXPECT_FALSE(schedule.begin(true, true, now));
    EXPECT_TRUE(schedule.lacks_still()) << "the job has begun; another one is needed";
    EXPECT_FALSE(schedule.begin(false, true, now)) << "no change waits";
    begin(true);
}

TEST_F(ViewScheduleTest, NoStillFollowsWhileANewerSceneWaits) {
    offer(1);
    const FrameTurn turn = begin(false);
    offer(2);
    schedule.made(turn, true, now);
    EXPECT_FALSE(schedule.lacks_still());
}

TEST_F(ViewScheduleTest, AChangeStopsAStillAtOnce) {
    show(1);
    wait(150ms);
    const FrameTurn still = begin(true);
    offer(2);
    EXPECT_TRUE(still.stop.stop_requested());
}

TEST_F(ViewScheduleTest, ASupersededFrameIsFinishedUnlessItTakesLong) {
    offer(1);
    const FrameTurn quick = begin(false);
    wait(500ms);
    offer(2);
    EXPECT_FALSE(quick.stop.stop_requested());
    schedule.made(quick, true, now);
    const FrameTurn slow = begin(false);
    wait(501ms);
    offer(3);
    EXPECT_TRUE(slow.stop.stop_requested());
}

TEST_F(ViewScheduleTest, OfTwoSlowFramesInARowOneIsFinished) {
    offer(1);
    begin(false);
    wait(1s);
    offer(2);
    schedule.given_up();
    const FrameTurn second = begin(false);
    wait(10s);
    offer(3);
    EXPECT_FALSE(second.stop.stop_requested());
    schedule.made(second, true, now);
    const FrameTurn third = begin(false);
    wait(1s);
    offer(4);
    EXPECT_TRUE(third.stop.stop_requested());
}

TEST_F(ViewScheduleTest, AStillGivesWayThreeTimes) {
    show(1);
    wait(150ms);
    for (int i = 0; i < 3; ++i) {
        const FrameTurn still = begin(true);
        EXPECT_FALSE(still.gives_way_at(now + 500ms));
        EXPECT_TRUE(still.gives_way_at(now + 501ms));
        schedule.gave_way(now);
    }
    const FrameTurn last = begin(true);
    EXPECT_FALSE(last.gives_way_at(now + 1h));
    schedule.made(last, false, now);
    show(2);
    wait(150ms);
    EXPECT_TRUE(begin(true).gives_way_at(now + 1s)) << "the next still picture counts from zero";
}

TEST_F(ViewScheduleTest, AFrameWithoutRoomIsMadeAgain) {
    offer(1);
    schedule.had_no_room(begin(false));
    const FrameTurn again = begin(false);
    EXPECT_EQ(again.version->revision, 1U);
    offer(2);
    schedule.had_no_room(again);
    EXPECT_EQ(begin(false).version->revision, 2U) << "not the older scene";
}

TEST_F(ViewScheduleTest, AStillWithoutRoomIsMadeAgain) {
    show(1);
    wait(150ms);
    schedule.had_no_room(begin(true));
    EXPECT_FALSE(schedule.has_change());
    EXPECT_TRUE(schedule.lacks_still());
}

TEST_F(ViewScheduleTest, TheSameSceneIsDrawnAgain) {
    EXPECT_FALSE(schedule.again()) << "there is no scene yet";
    offer(1);
    const FrameTurn turn = begin(false);
    EXPECT_TRUE(schedule.again());
    EXPECT_TRUE(turn.stop.stop_requested());
    schedule.given_up();
    EXPECT_EQ(begin(false).version->revision, 1U);
}

TEST_F(ViewScheduleTest, AFailedOrAwaitedSceneHasNoStill) {
    show(1);
    wait(150ms);
    begin(true);
    schedule.failed();
    EXPECT_FALSE(schedule.lacks_still());
    show(2);
    wait(150ms);
    begin(true);
    schedule.waits();
    EXPECT_FALSE(schedule.lacks_still());
}

TEST_F(ViewScheduleTest, AClosedViewMakesNoFrame) {
    offer(1);
    const FrameTurn turn = begin(false);
    offer(2);
    schedule.close();
    EXPECT_TRUE(turn.stop.stop_requested());
    schedule.given_up();
    EXPECT_FALSE(schedule.may_post());
    EXPECT_FALSE(schedule.begin(false, true, now));
}

} // namespace
} // namespace server::engine
