// Which late step is read next. Reading is under the control of the test; steps 0 and 9 have been read at the import.
#include "engine/schedule/late_step_queue.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/store_box/box.hpp"

#include <condition_variable>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>

namespace server::engine {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class LateSteps : public testing::Test {
protected:
    LateSteps() {
        const store::ArrayInfo p{"p", store::Association::point, 1, "", ""};
        store::Writer writer(folder / "box.ciel", {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(ciel::test::box(2, 2, 2), ciel::test::identity(27), ciel::test::identity(8), {});
        const auto add = [&](std::size_t step) {
            const auto points = ciel::test::values_of(27, step);
            writer.add_step(static_cast<double>(step), 0, 0, std::vector<store::ArrayValues>{{p, points}});
        };
        add(0);
        for (int step = 1; step < 9; ++step) writer.add_late_step(step, 0, 0, std::vector{p});
        add(9);
        writer.set_late({{"/data/box.vtu"}, {}, 1, {}, "a mesh"});
        writer.finish();
        dataset = store::Dataset::open(folder / "box.ciel");
        queue.emplace([this](const store::Dataset&, std::size_t step,
                             const std::atomic<bool>& cancel) { return read(step, cancel); },
                      [this](const std::filesystem::path& directory) {
                          EXPECT_EQ(directory, dataset->directory());
                          const std::scoped_lock lock(mutex);
                          ++told;
                          changed.notify_all();
                      });
    }

    // Blocks until the test lets the step end, or until it is cancelled.
    std::string read(std::size_t step, const std::atomic<bool>& cancel) {
        std::unique_lock lock(mutex);
        begun.push_back(step);
        changed.notify_all();
        while (!ended.contains(step) && !cancel) changed.wait_for(lock, std::chrono::milliseconds(5));
        if (!ended.contains(step)) {
            cancelled.push_back(step);
            return "cancelled";
        }
        return ended.at(step);
    }
    void end(std::size_t step, const std::string& problem = "") {
        const std::scoped_lock lock(mutex);
        ended[step] = problem;
        changed.notify_all();
    }
    void wait_for(const std::function<bool()>& state) {
        std::unique_lock lock(mutex);
        ASSERT_TRUE(changed.wait_for(lock, std::chrono::minutes(1), state));
    }
    void wait_until_begun(std::size_t step) {
        wait_for([&] { return std::ranges::find(begun, step) != begun.end(); });
    }
    store::LateAnswer ask(std::size_t step) { return queue->ask(*dataset, step); }

    const ciel::test::Folder folder;
    std::shared_ptr<store::Dataset> dataset;
    std::mutex mutex; // protects what follows
    std::condition_variable changed;
    std::vector<std::size_t> begun, cancelled;
    std::map<std::size_t, std::string> ended;
    int told = 0;
    std::optional<LateStepQueue> queue; // the last member, because its threads use the others
};

TEST_F(LateSteps, TheStepThatWasAskedForLastIsReadFirst) {
    EXPECT_EQ(ask(4).words, "is being read from its source");
    wait_until_begun(4);
    (void)ask(2);
    (void)ask(7);
    for (const std::size_t step : {4, 7, 2}) end(step);
    wait_for([&] { return told == 3; });
    wait_until_begun(3);
    const std::scoped_lock lock(mutex);
    EXPECT_THAT(begun, ElementsAre(4, 7, 2, 3)) << "then the step after the one that was read last";
    EXPECT_TRUE(cancelled.empty()) << "somebody waits for each of them";
}

TEST_F(LateSteps, StepsAheadGiveWayToAStepThatIsAskedFor) {
    end(1);
    (void)ask(1);
    wait_until_begun(2); // ahead
    end(6);
    (void)ask(6);
    wait_until_begun(7);
    end(7);
    wait_until_begun(8);
    const std::scoped_lock lock(mutex);
    EXPECT_THAT(begun, ElementsAre(1, 2, 6, 7, 8));
    EXPECT_THAT(cancelled, ElementsAre(2));
    EXPECT_EQ(told, 2) << "nobody waits for a step ahead";
}

TEST_F(LateSteps, AStepAheadThatIsAskedForMeanwhileGoesOn) {
    end(1);
    (void)ask(1);
    wait_until_begun(2);
    (void)ask(2);
    end(2);
    wait_for([&] { return told == 2; });
    const std::scoped_lock lock(mutex);
    EXPECT_TRUE(cancelled.empty());
}

TEST_F(LateSteps, AStepThatFailsIsNotReadAgainAtOnce) {
    end(3, "run.vtu is truncated");
    (void)ask(3);
    wait_for([&] { return told == 1; });
    const store::LateAnswer answer = ask(3);
    EXPECT_EQ(answer.words, "cannot be read from its source: run.vtu is truncated");
    EXPECT_TRUE(answer.has_failed);
    const std::scoped_lock lock(mutex);
    EXPECT_THAT(begun, ElementsAre(3)) << "no step follows one that failed";
}

TEST_F(LateSteps, EndsAtOnceWhileAStepIsRead) {
    (void)ask(3);
    wait_until_begun(3);
    queue.reset();
    EXPECT_THAT(cancelled, ElementsAre(3));
    EXPECT_EQ(told, 0);
}

} // namespace
} // namespace server::engine
