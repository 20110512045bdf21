// The real gateway on a loopback socket, and plain socket clients for it.
#pragma once

#include "app/engine_service.hpp"
#include "gateway/gateway.hpp"
#include "support/chosen_algorithm.hpp"

#include <arpa/inet.h>
#include <csignal>
#include <future>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace server::gateway {
using namespace ciel;

// Serves from construction to destruction. Only one may exist: the destructor ends it by sending SIGTERM to the
// process.
class RunningServer {
public:
    // `data`: datasets to serve.
    explicit RunningServer(limits::Limits limits = {}, const std::vector<std::filesystem::path>& data = {}) {
        std::promise<Listening> at;
        auto listening = at.get_future();
        thread_ = std::thread([promise = std::move(at), limits, data]() mutable {
            engine::ServerOptions server_options;
            server_options.extraction = test::chosen_algorithm();
            server_options.limits = limits;
            server_options.data = data;
            engine::Server server(std::move(server_options));
            GatewayOptions options;
            options.port = 0;
            options.prefix = "/ciel";
            options.version = "test";
            options.origins = {"https://lab.example.org"};
            app::EngineService service(server);
            serve(service, options, [&](const Listening& where) { promise.set_value(where); });
        });
        listening_ = listening.get();
    }
    ~RunningServer() {
        if (!thread_.joinable()) return;
        kill(getpid(), SIGTERM);
        thread_.join();
    }
    void wait() { thread_.join(); } // waits until the server has ended after a signal
    RunningServer(const RunningServer&) = delete;
    [[nodiscard]] unsigned short port() const { return listening_.port; }
    [[nodiscard]] std::string authorization() const { return "Authorization: Bearer " + listening_.token + "\r\n"; }

private:
    std::thread thread_;
    Listening listening_;
};

class Socket {
public:
    // `receive_buffer`: size of SO_RCVBUF, for clients that do not read; 0 keeps the default.
    explicit Socket(const RunningServer& server, int receive_buffer = 0) : Socket(server.port(), receive_buffer) {}
    explicit Socket(unsigned short port, int receive_buffer = 0) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        if (receive_buffer > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        // A server that neither answers nor closes in this time fails the test.
        const timeval patience{patience_seconds, 0};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    }
    ~Socket() { ::close(socket_); }
    Socket(const Socket&) = delete;

    // Returns false when the server has closed. Fails the test when the server does not read for too long.
    bool send(const std::string& bytes) {
        for (std::size_t sent = 0; sent < bytes.size();) {
            const auto some = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
            if (some < 0) {
                EXPECT_TRUE(errno == EPIPE || errno == ECONNRESET) << "nothing was taken";
                return false;
            }
            sent += static_cast<std::size_t>(some);
        }
        return true;
    }
    void end_of_requests() { ::shutdown(socket_, SHUT_WR); }

    // True when data or the end of the connection arrives within a short time.
    [[nodiscard]] bool is_answered() const {
        pollfd waiting{socket_, POLLIN, 0};
        return ::poll(&waiting, 1, look_milliseconds) > 0;
    }
    // Returns the next `count` bytes, or fewer when the server closes first.
    std::string receive(std::size_t count) {
        std::string bytes(count, '\0');
        std::size_t got = 0;
        while (got < count) {
            const auto some = ::recv(socket_, bytes.data() + got, count - got, 0);
            EXPECT_TRUE(some >= 0 || errno == ECONNRESET) << "neither an answer nor an end";
            if (some <= 0) break;
            got += static_cast<std::size_t>(some);
        }
        bytes.resize(got);
        return bytes;
    }
    // Returns everything up to and including `end`, or less when the server closes first.
    std::string receive_until(std::string_view end) {
        std::string bytes;
        while (!bytes.ends_with(end)) {
            const std::string byte = receive(1);
            if (byte.empty()) break;
            bytes += byte;
        }
        return bytes;
    }
    // Returns everything until the server closes.
    std::string receive_all() {
        std::string all;
        for (std::string some; !(some = receive(block_bytes)).empty();) all += some;
        return all;
    }

private:
    static constexpr int patience_seconds = 20, look_milliseconds = 20;
    static constexpr std::size_t block_bytes = 65536;

    int socket_;
};

} // namespace server::gateway
