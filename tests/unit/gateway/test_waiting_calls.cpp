// WebSocket messages that arrive while a call runs: how many bytes of them the server reads.
#include "hand_made.hpp"

#include <atomic>
#include <chrono>
#include <latch>

namespace server::gateway {
namespace {

constexpr std::size_t message_bytes = 60'000, most_waiting = 100'000;
constexpr int messages = 60;

// Its calls wait until `go_on` is counted down.
class WaitingService final : public Service {
public:
    std::latch go_on{1};
    std::atomic<int> begun = 0;

    WaitingService() { limits_.waiting_call_bytes = most_waiting; }

    const limits::Limits& limits() const override { return limits_; }
    limits::Memory& memory() override { return memory_; }
    std::shared_ptr<Peer> connect(Client client) override {
        class Waiting final : public Peer {
        public:
            explicit Waiting(WaitingService& service, Client client) : service_(service), client_(std::move(client)) {}
            void text(std::string_view text, Answer answer) override {
                ++service_.begun;
                service_.go_on.wait();
                answer(std::to_string(text.size()));
            }
            std::optional<std::string> binary(std::span<const std::uint8_t>) override { return {}; }
            void has_room() override {}
            void closed() override {}

        private:
            WaitingService& service_;
            Client client_;
        };
        return std::make_shared<Waiting>(*this, std::move(client));
    }
    Readiness readiness() override { return {true}; }
    std::string metrics() override { return {}; }
    void announce_end() override {}
    void drain_frames() override {}
    void drain() override {}
    void give_up() override {}

private:
    limits::Limits limits_;
    limits::Memory memory_{1 << 30, [] { return std::uint64_t(0); }, [] {}};
};

TEST(WaitingCallBytes, BoundWhatIsReadWhileACallRuns) {
    WaitingService service;
    std::promise<unsigned short> port;
    std::thread server([&] {
        GatewayOptions options;
        options.port = 0;
        serve(service, options, [&](const Listening& where) { port.set_value(where.port); });
    });
    {
        HandMade client(port.get_future().get());
        std::thread sender([&] { // may wait until the server reads on
            for (int i = 0; i < messages; ++i) client.send_frame(text, std::string(message_bytes, 'x'));
        });
        const auto waiting = [&] { return service.memory().bytes(limits::Held::requests); };
        const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (waiting() <= most_waiting && std::chrono::steady_clock::now() < patience)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        std::this_thread::sleep_for(std::chrono::milliseconds(200)); // time in which a faulty server would read more
        EXPECT_EQ(waiting(), 2 * message_bytes) << "only the message that passes the limit is read beyond it";
        EXPECT_EQ(service.begun, 1) << "messages are handled in order";

        service.go_on.count_down();
        for (int i = 0; i < messages; ++i)
            EXPECT_EQ(client.receive_frame(), std::pair(int(text), std::to_string(message_bytes)));
        sender.join();
        EXPECT_EQ(service.begun, messages);
    }
    kill(getpid(), SIGTERM);
    server.join();
}

} // namespace
} // namespace server::gateway
