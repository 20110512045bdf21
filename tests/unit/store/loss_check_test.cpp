// LossCheck: how often the files of a dataset are looked at after one of them was lost.
#include "store/cache/loss_check.hpp"

#include "ciel/types.hpp"

#include <gtest/gtest.h>

namespace server::store {
namespace {

class LossCheckTest : public testing::Test {
protected:
    void check() {
        check_([this] {
            ++looks_;
            if (lost_file_is_mapped_) throw ciel::Error("lost");
        });
    }

    LossCount losses_ = no_losses();
    LossCheck check_{losses_};
    int looks_ = 0;
    bool lost_file_is_mapped_ = false;
};

TEST_F(LossCheckTest, without_a_loss_no_file_is_looked_at) {
    for (int i = 0; i < 3; ++i) check();
    EXPECT_EQ(looks_, 0);
}

TEST_F(LossCheckTest, a_loss_is_found_at_each_check_while_the_file_is_mapped) {
    ++*losses_;
    lost_file_is_mapped_ = true;
    for (int i = 0; i < 3; ++i) EXPECT_THROW(check(), ciel::Error);
    EXPECT_EQ(looks_, 3);
}

TEST_F(LossCheckTest, a_loss_that_was_let_go_does_not_slow_later_checks) {
    ++*losses_;
    lost_file_is_mapped_ = true;
    EXPECT_THROW(check(), ciel::Error);
    lost_file_is_mapped_ = false;
    for (int i = 0; i < 3; ++i) check();
    EXPECT_EQ(looks_, 2) << "one look that throws, and one that finds no lost file any more";
}

TEST_F(LossCheckTest, the_next_loss_is_looked_for_again) {
    ++*losses_;
    check();
    ++*losses_;
    lost_file_is_mapped_ = true;
    EXPECT_THROW(check(), ciel::Error);
    EXPECT_EQ(looks_, 2);
}

} // namespace
} // namespace server::store
