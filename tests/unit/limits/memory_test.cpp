#include "limits/errors.hpp"
#include "limits/memory.hpp"

#include <atomic>
#include <gmock/gmock.h>
#include <optional>
#include <thread>
#include <vector>

namespace server::limits {
namespace {

class memory : public testing::Test {
protected:
    std::atomic<std::uint64_t> of_datasets = 0;
    std::atomic<int> released = 0;
    Memory all{1000, [this] { return of_datasets.load(); },
               [this] {
                   ++released;
                   of_datasets = 0;
               }};
};

TEST_F(memory, charges_count_until_they_end) {
    {
        Memory::Charge scenes(all, Held::scenes), more(all, Held::scenes), answers(all, Held::answers);
        scenes.change(300);
        more.change(200);
        answers.change(100);
        scenes.change(50);
        EXPECT_EQ(all.bytes(Held::scenes), 250U);
        EXPECT_EQ(all.bytes(Held::answers), 100U);
        EXPECT_EQ(all.room(), 650U);
    }
    EXPECT_EQ(all.room(), 1000U);
}

TEST_F(memory, what_would_pass_the_total_is_refused_and_changes_nothing) {
    Memory::Charge first(all, Held::scenes), second(all, Held::surfaces);
    first.change(700);
    second.change(300);
    EXPECT_THROW(second.change(301), LimitReached);
    EXPECT_THROW(first.change(701), LimitReached);
    EXPECT_EQ(all.room(), 0U);
    EXPECT_EQ(second.bytes(), 300U);
    first.change(600);
    EXPECT_NO_THROW(second.change(400));
}

TEST_F(memory, datasets_count_and_unused_ones_are_released_first) {
    Memory::Charge charge(all, Held::answers);
    of_datasets = 600;
    EXPECT_NO_THROW(charge.change(400));
    EXPECT_EQ(released, 0);
    EXPECT_NO_THROW(charge.change(900));
    EXPECT_EQ(released, 1);
    EXPECT_THROW(charge.change(1001), LimitReached);
}

TEST_F(memory, what_is_there_already_is_never_refused) {
    Memory::Charge charge(all, Held::unsent), other(all, Held::scenes);
    charge.note(2000);
    EXPECT_EQ(all.room(), 0U);
    EXPECT_THROW(other.change(1), LimitReached);
    charge.note(0);
    EXPECT_NO_THROW(other.change(1));
}

TEST_F(memory, the_total_holds_for_many_at_a_time) {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([this] {
            Memory::Charge charge(all, Held::answers);
            for (int round = 0; round < 1000; ++round) {
                try {
                    charge.change(400);
                    EXPECT_LE(all.bytes(Held::answers), 1000U);
                } catch (const LimitReached&) {
                }
                charge.change(0);
            }
        });
    threads.clear();
    EXPECT_EQ(all.room(), 1000U);
}

} // namespace
} // namespace server::limits
