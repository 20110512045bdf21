// Parses rows of /proc/net/tcp and tcp6 as Linux 5.10 to 6.12 write them on a little-endian machine.
#include "gateway/peer_owner.hpp"

#include <bit>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace server::gateway {
namespace {

const std::string heading =
    "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n";
const std::string client = "0100007F:D431", server = "0100007F:1F90";

std::string row(const std::string& local, const std::string& remote, const char* state, const char* user,
                const char* inode) {
    return "   7: " + local + " " + remote + " " + state + " 00000000:00000000 00:00000000 00000000  " + user +
           "        0 " + inode + " 1 0000000000000000 20 4 30 10 -1                     \n";
}

bool lists(const std::string& rows, std::uint32_t user) {
    std::istringstream table(heading + rows);
    return sockets_of(table, user).contains(client + " " + server);
}

TEST(SocketRow, IsTakenApart) {
    const std::string line = row(client, server, "01", "1000", "424242");
    const auto parsed = parse_socket_row(line);
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->local, client);
    EXPECT_EQ(parsed->remote, server);
    EXPECT_EQ(parsed->state, 1U);
    EXPECT_EQ(parsed->user, 1000U);
    EXPECT_EQ(parsed->inode, 424242U);
}

TEST(SocketRow, OfAnotherFormIsNone) {
    for (const std::string& line : {std::string(), heading, std::string("   7:"), std::string("   7: a b"),
                                    row(client, server, "zz", "1000", "1"), row(client, server, "01", "-1", "1"),
                                    row(client, server, "01", "4294967296", "1"), row(client, server, "01", "1", "x"),
                                    row(client, server, "01", "1000", "99999999999999999999999")})
        EXPECT_FALSE(parse_socket_row(line)) << line;
}

TEST(SocketName, IsTheTables) {
    if (std::endian::native != std::endian::little)
        GTEST_SKIP() << "the addresses are those of a little-endian machine";
    const auto name = [](const char* address, unsigned short port) {
        return socket_name(asio::ip::make_address(address), port);
    };
    EXPECT_EQ(name("127.0.0.1", 8080), server);
    EXPECT_EQ(name("192.168.1.20", 22), "1401A8C0:0016");
    EXPECT_EQ(name("::1", 80), "00000000000000000000000001000000:0050");
    EXPECT_EQ(name("::ffff:127.0.0.1", 8080), "0000000000000000FFFF00000100007F:1F90");
    EXPECT_EQ(name("2001:db8::ff00:42:8329", 1), "B80D01200000000000FF000029834200:0001");
}

TEST(Owner, IsTheUserOfAnEstablishedSocket) {
    EXPECT_TRUE(lists(row(client, server, "01", "1000", "42"), 1000));
    EXPECT_FALSE(lists(row(client, server, "01", "1001", "42"), 1000));
    EXPECT_FALSE(lists("", 1000));
    EXPECT_FALSE(lists(row(server, client, "01", "1000", "42"), 1000)) << "this is our own end";
    EXPECT_FALSE(lists(row(client, "0100007F:1F91", "01", "1000", "42"), 1000)) << "to another server";
    EXPECT_FALSE(lists(row("0100007F:D432", server, "01", "1000", "42"), 1000)) << "of another port";
    for (const char* state : {"02", "04", "05", "06", "07", "08", "0A"})
        EXPECT_FALSE(lists(row(client, server, state, "1000", "42"), 1000)) << state;
}

// Linux lists a closed socket with user 0 and inode 0, whoever owned it. A server run by root must not take it for its
// own.
TEST(Owner, IsNobodyWhenTheProcessHasClosed) {
    EXPECT_FALSE(lists(row(client, server, "01", "0", "0"), 0));
    EXPECT_FALSE(lists(row(client, server, "06", "0", "0"), 0)) << "TIME_WAIT";
    EXPECT_TRUE(lists(row(client, server, "01", "0", "42"), 0));
}

TEST(Owner, OfAReusedPortIsTheOneThatIsConnected) {
    const std::string stale = row(client, server, "06", "0", "0");
    EXPECT_TRUE(lists(stale + row(client, server, "01", "1000", "42"), 1000));
    EXPECT_FALSE(lists(stale + row(client, server, "01", "1001", "42"), 1000));
    EXPECT_FALSE(lists(stale + row(client, server, "01", "1001", "42"), 0));
}

// 65534 stands for every user outside the user namespace.
TEST(Owner, IsNeverTheOverflowUser) { EXPECT_FALSE(lists(row(client, server, "01", "65534", "42"), 65534)); }

class OwnSocketsTest : public testing::Test {
protected:
    const asio::ip::tcp::endpoint peer{asio::ip::make_address("127.0.0.1"), 0xD431};
    const asio::ip::tcp::endpoint own{asio::ip::make_address("127.0.0.1"), 8080};
    std::string rows;
    int readings = 0;
    OwnSockets sockets{[this](const char* path) {
        ++readings;
        return std::make_unique<std::istringstream>(path == std::string("/proc/net/tcp") ? heading + rows : heading);
    }};
    const std::string held = row(client, server, "01", std::to_string(::geteuid()).c_str(), "42");
};

// Reading the tables takes milliseconds. Many connections share one reading that started after they asked.
TEST_F(OwnSocketsTest, AreReadOnceForAllWhoAskedBefore) {
    rows = held;
    const auto asked = OwnSockets::Clock::now();
    for (int i = 0; i < 400; ++i) EXPECT_TRUE(sockets.contain(peer, own, asked));
    for (unsigned short i = 1; i < 400; ++i)
        EXPECT_FALSE(sockets.contain({peer.address(), static_cast<unsigned short>(peer.port() + i)}, own, asked));
    EXPECT_EQ(readings, 2) << "one of each table";
}

TEST_F(OwnSocketsTest, OfBeforeTheQuestionAreTooOld) {
    EXPECT_FALSE(sockets.contain(peer, own, OwnSockets::Clock::now()));
    rows = held;
    EXPECT_TRUE(sockets.contain(peer, own, OwnSockets::Clock::now()));
    rows = row(client, server, "01", "0", "0");
    EXPECT_FALSE(sockets.contain(peer, own, OwnSockets::Clock::now())) << "another took the port";
}

} // namespace
} // namespace server::gateway
