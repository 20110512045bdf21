#include "gateway/hang_up.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/write.hpp>
#include <gtest/gtest.h>

namespace server::gateway {
namespace {

class HangUp : public testing::Test {
protected:
    HangUp() {
        asio::ip::tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
        client.connect(acceptor.local_endpoint());
        acceptor.accept(server);
        server.non_blocking(false);
    }

    asio::io_context io;
    asio::ip::tcp::socket client{io}, server{io};
};

TEST_F(HangUp, APeerWithoutInputWaits) { EXPECT_EQ(state_of_peer(server), PeerState::waits); }

TEST_F(HangUp, InputStaysToBeRead) {
    asio::write(client, asio::buffer("x", 1));
    server.wait(asio::ip::tcp::socket::wait_read);
    EXPECT_EQ(state_of_peer(server), PeerState::sends);
    EXPECT_EQ(server.available(), 1U);
    client.close();
    EXPECT_EQ(state_of_peer(server), PeerState::sends) << "a request comes before the end";
    char byte = 0;
    EXPECT_EQ(server.read_some(asio::buffer(&byte, 1)), 1U);
    EXPECT_EQ(state_of_peer(server), PeerState::hung_up);
}

TEST_F(HangUp, APeerThatShutItsSideHasHungUp) {
    client.shutdown(asio::ip::tcp::socket::shutdown_send);
    server.wait(asio::ip::tcp::socket::wait_read);
    EXPECT_EQ(state_of_peer(server), PeerState::hung_up);
}

TEST_F(HangUp, APeerThatResetTheConnectionHasHungUp) {
    client.set_option(asio::socket_base::linger(true, 0));
    client.close();
    server.wait(asio::ip::tcp::socket::wait_read);
    EXPECT_EQ(state_of_peer(server), PeerState::hung_up);
}

} // namespace
} // namespace server::gateway
