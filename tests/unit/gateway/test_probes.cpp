// Probes of operators are answered while every worker is busy with methods.
#include "running_server.hpp"

#include <condition_variable>
#include <gmock/gmock.h>
#include <mutex>

namespace server::gateway {
namespace {

using testing::StartsWith;

// A service whose methods wait until open() is called.
class Stuck final : public Service {
public:
    class Caller final : public Peer {
    public:
        explicit Caller(Stuck& of) : of_(of) {}
        void text(std::string_view, Answer answer) override {
            of_.wait();
            answer("{}");
        }
        std::optional<std::string> binary(std::span<const std::uint8_t>) override { return {}; }
        void has_room() override {}
        void closed() override {}

    private:
        Stuck& of_;
    };

    [[nodiscard]] const limits::Limits& limits() const override { return limits_; }
    [[nodiscard]] limits::Memory& memory() override { return memory_; }
    [[nodiscard]] std::shared_ptr<Peer> connect(Client) override { return std::make_shared<Caller>(*this); }
    [[nodiscard]] Readiness readiness() override { return {.ready = true}; }
    [[nodiscard]] std::string metrics() override { return "ciel_up 1\n"; }
    void announce_end() override {}
    void drain_frames() override {}
    void drain() override { open(); }
    void give_up() override {}

    void wait_for_callers(unsigned count) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return waiting_ >= count; });
    }
    void open() {
        const std::scoped_lock lock(mutex_);
        is_open_ = true;
        changed_.notify_all();
    }

private:
    void wait() {
        std::unique_lock lock(mutex_);
        ++waiting_;
        changed_.notify_all();
        changed_.wait(lock, [&] { return is_open_; });
    }

    limits::Limits limits_;
    limits::Memory memory_{limits_.memory_bytes, [] { return std::uint64_t{0}; }, [] {}};
    std::mutex mutex_;
    std::condition_variable changed_;
    unsigned waiting_ = 0;
    bool is_open_ = false;
};

TEST(Probes, AreAnsweredWhileEveryWorkerIsBusy) {
    Stuck service;
    std::promise<Listening> at;
    auto listening = at.get_future();
    GatewayOptions options;
    options.port = 0;
    options.workers = 2;
    std::thread thread([&] { serve(service, options, [&](const Listening& where) { at.set_value(where); }); });
    const unsigned short port = listening.get().port;
    const std::string call = "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
                             "Content-Length: 2\r\n\r\n{}";
    {
        Socket one(port), other(port), probe(port);
        one.send(call);
        other.send(call);
        service.wait_for_callers(options.workers);
        for (const char* path : {"/readyz", "/metrics"}) {
            probe.send("GET " + std::string(path) + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
            EXPECT_THAT(probe.receive_until("\r\n\r\n"), StartsWith("HTTP/1.1 200 ")) << path;
            probe.receive_until(std::string(path) == "/readyz" ? "}" : "ciel_up 1\n");
        }
        service.open();
        EXPECT_THAT(one.receive_until("\r\n\r\n"), StartsWith("HTTP/1.1 200 "));
    }
    kill(getpid(), SIGTERM);
    thread.join();
}

} // namespace
} // namespace server::gateway
