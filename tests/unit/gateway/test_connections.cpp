// Admission of connections, and which one is closed when there is no place left.
#include "gateway/connections.hpp"

#include "logging/log_limiter.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace server::gateway {
namespace {

class Places : public testing::Test {
protected:
    using Ticket = std::shared_ptr<Connections::Ticket>;

    // Numbers of the closed connections, in order. Connections are numbered from 0 in the order of opening.
    std::vector<int> cut_;

    static constexpr std::size_t most = 8, reserved = 2, of_address = 3;
    Connections connections_{{most, reserved, of_address}};
    int opened_ = 0;

    Ticket open(const std::string& key = {}, bool needs_room = false) {
        return connections_.open(key, needs_room, {[] {}, [this, number = opened_++] { cut_.push_back(number); }});
    }
    Ticket open_let_in() {
        auto ticket = open();
        EXPECT_TRUE(ticket->begin_request(true, {}));
        return ticket;
    }
    std::vector<Ticket> open_many(std::size_t count) {
        std::vector<Ticket> tickets;
        while (tickets.size() < count) tickets.push_back(open());
        return tickets;
    }
};

TEST_F(Places, TheOldestThatIsIdleGoesFirst) {
    const auto busy = open_let_in();
    auto kept = open_let_in();
    kept->end_request(); // the connection now waits for its next request
    const auto more = open_many(most - reserved);
    EXPECT_TRUE(cut_.empty());
    const auto last = open();
    EXPECT_EQ(cut_, std::vector<int>{2}) << "the places of those that are known are kept";
    EXPECT_FALSE(last->is_refused());
    const auto known = open_let_in();
    EXPECT_EQ(cut_, (std::vector<int>{2, 3}));
    const auto another = open();
    EXPECT_EQ(cut_, (std::vector<int>{2, 3, 1})) << "all places are taken: the oldest of all that may go";
}

TEST_F(Places, StrangersNeverTakeTheReservedOnes) {
    const auto strangers = open_many(100);
    EXPECT_EQ(cut_.size(), 100 - (most - reserved));
    std::vector<Ticket> known;
    for (std::size_t i = 0; i < most; ++i) {
        known.push_back(open_let_in());
        EXPECT_FALSE(known.back()->is_refused()) << i;
    }
    for (const int number : cut_) EXPECT_LT(number, 100) << "only strangers had to go";
}

TEST_F(Places, AreRefusedWhereAllAreBusy) {
    std::vector<Ticket> busy;
    for (std::size_t i = 0; i < most; ++i) busy.push_back(open_let_in());
    const auto refused = open();
    EXPECT_TRUE(refused->is_refused());
    EXPECT_TRUE(cut_.empty());
    busy.pop_back();
    EXPECT_FALSE(open()->is_refused()) << "one that is refused takes no place";
}

TEST_F(Places, OfRefusalsAreFewToo) {
    std::vector<Ticket> busy, refused;
    for (std::size_t i = 0; i < most; ++i) busy.push_back(open_let_in());
    for (int i = 0; i < 32; ++i) refused.push_back(open());
    EXPECT_NE(refused.back(), nullptr);
    EXPECT_EQ(open(), nullptr) << "closed without a word";
}

TEST_F(Places, ARequestThatWasNotLetInIsNotSpared) {
    const auto stranger = open();
    EXPECT_TRUE(stranger->begin_request(false, {}));
    const auto more = open_many(most - reserved);
    EXPECT_EQ(cut_, std::vector<int>{0});
}

TEST_F(Places, OfOneAddressAreLimited) {
    const auto first = open("192.0.2.1"), second = open("192.0.2.1"), third = open("192.0.2.1");
    EXPECT_TRUE(first->begin_request(true, {}));
    const auto other = open("192.0.2.2");
    EXPECT_TRUE(cut_.empty());
    const auto fourth = open("192.0.2.1");
    EXPECT_EQ(cut_, std::vector<int>{1}) << "its own oldest idle one goes";
    EXPECT_TRUE(third->begin_request(true, {}));
    EXPECT_TRUE(fourth->begin_request(true, {}));
    EXPECT_TRUE(open("192.0.2.1")->is_refused());
    EXPECT_FALSE(open("192.0.2.2")->is_refused());
    EXPECT_FALSE(open()->is_refused()) << "loopback is not counted";
}

TEST_F(Places, BehindAProxyAreCountedByRequest) {
    const auto connections = open_many(of_address + 1);
    for (std::size_t i = 0; i < of_address; ++i) EXPECT_TRUE(connections[i]->begin_request(true, "192.0.2.1"));
    EXPECT_FALSE(connections[of_address]->begin_request(true, "192.0.2.1"));
    EXPECT_TRUE(connections[of_address]->begin_request(true, "192.0.2.2"));
    connections[0]->end_request();
    EXPECT_TRUE(connections[0]->begin_request(true, "192.0.2.1"));
}

TEST_F(Places, ShortOfDescriptorsOneGoesForEachThatComes) {
    const auto busy = open_let_in(), idle = open();
    const auto first = open({}, true);
    EXPECT_FALSE(first->is_refused());
    EXPECT_EQ(cut_, std::vector<int>{1});
    EXPECT_TRUE(first->begin_request(true, {}));
    EXPECT_EQ(open({}, true), nullptr) << "even a refusal needs a descriptor";
}

TEST_F(Places, ThatWereCutAreNotCutAgainAndLiveUntilTheyEnd) {
    auto tickets = open_many(most - reserved + 2);
    EXPECT_EQ(cut_, (std::vector<int>{0, 1}));
    EXPECT_EQ(connections_.count(), most - reserved + 2);
    EXPECT_EQ(connections_.cut_count(), 2U);
    tickets.clear();
    EXPECT_EQ(connections_.count(), 0U);
}

TEST_F(Places, FewAreSharedInHalves) {
    Connections small({2, 32, 64});
    std::vector<int> cut;
    const auto first = small.open("", false, {[] {}, [&] { cut.push_back(1); }});
    EXPECT_TRUE(first->begin_request(true, {}));
    const auto second = small.open("", false, {[] {}, [&] { cut.push_back(2); }});
    EXPECT_FALSE(second->is_refused());
    EXPECT_TRUE(cut.empty());
}

TEST(LogLimiter, AllowsOneLineAMinuteAndTopic) {
    logging::LogLimiter limiter;
    const auto start = logging::LogLimiter::Clock::now();
    EXPECT_TRUE(limiter.allows("a", start));
    EXPECT_TRUE(limiter.allows("b", start));
    EXPECT_FALSE(limiter.allows("a", start + std::chrono::seconds(59)));
    EXPECT_TRUE(limiter.allows("a", start + std::chrono::seconds(60)));
    EXPECT_FALSE(limiter.allows("a", start + std::chrono::seconds(61)));
}

TEST(LogLimiter, RemembersABoundedNumberOfTopics) {
    logging::LogLimiter limiter;
    const auto start = logging::LogLimiter::Clock::now();
    int allowed = 0;
    for (int i = 0; i < 10'000; ++i) allowed += limiter.allows(std::to_string(i), start) ? 1 : 0;
    EXPECT_EQ(allowed, 4096);
    EXPECT_TRUE(limiter.allows("new", start + std::chrono::minutes(1))) << "old ones make room";
}

} // namespace
} // namespace server::gateway
