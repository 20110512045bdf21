#include "gateway/remote_address.hpp"

#include "ciel/types.hpp"

#include <gtest/gtest.h>

namespace server::gateway {
using namespace ciel;
namespace {

asio::ip::address address(const char* text) { return asio::ip::make_address(text); }

TEST(ForwardedFor, IsTheLastAddress) {
    const struct {
        const char *header, *last;
    } rows[]{
        {"192.0.2.1", "192.0.2.1"},       {"203.0.113.9, 192.0.2.1", "192.0.2.1"}, {"evil,,  192.0.2.1 ", "192.0.2.1"},
        {"192.0.2.1:5000", "192.0.2.1"},  {"2001:db8::1", "2001:db8::1"},          {"[2001:db8::1]:443", "2001:db8::1"},
        {"[2001:db8::1]", "2001:db8::1"}, {"::ffff:192.0.2.1", "192.0.2.1"},
    };
    for (const auto& row : rows) {
        const auto last = last_forwarded_for(row.header);
        ASSERT_TRUE(last) << row.header;
        EXPECT_EQ(last->to_string(), row.last) << row.header;
    }
    for (const char* header : {"", ",", "192.0.2.1,", "unknown", "_hidden", "192.0.2.1, unknown", "192.0.2", "[", "[]",
                               "[2001:db8::1", "1.2.3.4.5", "192.0.2.1 192.0.2.2"})
        EXPECT_FALSE(last_forwarded_for(header)) << header;
}

TEST(CountingKey, IsAHostOrANetworkOf64BitsAndNeverLoopback) {
    EXPECT_EQ(counting_key(address("192.0.2.1")), "192.0.2.1");
    EXPECT_EQ(counting_key(address("::ffff:192.0.2.1")), "192.0.2.1");
    EXPECT_EQ(counting_key(address("2001:db8:1:2:3:4:5:6")), counting_key(address("2001:db8:1:2::9")));
    EXPECT_NE(counting_key(address("2001:db8:1:2::9")), counting_key(address("2001:db8:1:3::9")));
    for (const char* local : {"127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"})
        EXPECT_EQ(counting_key(address(local)), "") << local;
}

TEST(LoggedAddress, IsTheCountingKeyOrTheAddressItself) {
    EXPECT_EQ(logged_address("2001:db8:1:2:3:4:5:6"), logged_address("2001:db8:1:2::9"));
    EXPECT_EQ(logged_address("192.0.2.1"), "192.0.2.1");
    EXPECT_EQ(logged_address("127.0.0.1"), "127.0.0.1");
    EXPECT_EQ(logged_address("none"), "none");
}

TEST(TrustedProxies, AreAddressesAndRanges) {
    const TrustedProxies proxies({"10.0.0.7", "172.30.0.0/16", "fd00::/8", "2001:db8::5"});
    for (const char* in : {"10.0.0.7", "172.30.255.1", "::ffff:172.30.0.9", "fd12::1", "2001:db8::5"})
        EXPECT_TRUE(proxies.contains(address(in))) << in;
    for (const char* out : {"10.0.0.8", "172.31.0.1", "fe80::1", "2001:db8::6", "127.0.0.1"})
        EXPECT_FALSE(proxies.contains(address(out))) << out;
    EXPECT_FALSE(TrustedProxies({}).contains(address("127.0.0.1")));
    for (const char* bad : {"proxy", "", "10.0.0.0/33", "10.0.0", "fd00::/129", "10.0.0.0/x"})
        EXPECT_THROW(TrustedProxies({bad}), Error) << bad;
}

} // namespace
} // namespace server::gateway
