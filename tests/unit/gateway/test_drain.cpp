// SIGTERM during a call or with a client that does not read: what the server waits for, and the order of messages. Each
// test runs in a child process, because a server that stops waiting exits the process with 0.
#include "hand_made.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <optional>

namespace server::gateway {
using namespace ciel;
namespace {

constexpr unsigned never = 100'000;
// Half of the time is for the picture to finish, the rest to abandon it, which takes seconds on a loaded machine.
#ifdef __SANITIZE_THREAD__
constexpr unsigned enough_to_abandon = 36; // ThreadSanitizer takes longer for both
#else
constexpr unsigned enough_to_abandon = 20;
#endif
constexpr int as_expected = 7;

// Drawn completely in software, this picture takes more than half a minute.
const std::string heavy_picture =
    R"({"jsonrpc":"2.0","id":1,"method":"picture.render","params":{"width":4000,"height":4000,"scene":{"dataset":"box",)"
    R"("layers":{"lines":{"type":"edges","width":32,"opacity":0.3}}}}})";

class Stopping {
public:
    explicit Stopping(unsigned drain_seconds) {
        limits::Limits limits;
        limits.drain_seconds = drain_seconds;
        test::write_small_dataset(folder_.path() / "box.ciel");
        server.emplace(limits, std::vector{folder_.path()});
    }
    void wait_until_drawing() const {
        std::string metrics;
        do {
            Socket socket(*server);
            socket.send("GET /metrics HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
            metrics = socket.receive_all();
        } while (metrics.find("\nciel_slow_calls 1\n") == std::string::npos ||
                 metrics.find("\nciel_frame_workers_busy 1\n") == std::string::npos);
    }
    static void signal() { kill(getpid(), SIGTERM); }

private:
    test::Folder folder_;

public:
    std::optional<RunningServer> server;
};

// Returns "text" for a text, "close 1001" for a close frame, "end" at the end of the connection.
std::string next(HandMade& client, std::string* payload = nullptr) {
    auto [opcode, bytes] = client.receive_frame();
    if (payload != nullptr) *payload = bytes;
    if (opcode == text) return "text";
    if (opcode == close_frame && bytes.size() >= 2)
        return "close " +
               std::to_string(static_cast<unsigned char>(bytes[0]) << 8 | static_cast<unsigned char>(bytes[1]));
    return opcode < 0 ? "end" : "another";
}

void expect_order(HandMade& client, const std::vector<std::string>& wanted) {
    for (const std::string& each : wanted)
        if (const std::string got = next(client); got != each) {
            std::fprintf(stderr, "%s instead of %s\n", got.c_str(), each.c_str());
            std::_Exit(1);
        }
}

void idle_client_beside_a_slow_call() {
    Stopping stopping(never);
    std::optional<HandMade> idle(*stopping.server);
    std::optional<HandMade> busy(*stopping.server);
    busy->send_frame(text, heavy_picture);
    stopping.wait_until_drawing();
    Stopping::signal();
    expect_order(*idle, {"text", "close 1001"}); // arrives while the picture is being drawn
    idle->send_frame(close_frame, "\x03\xE9");
    idle.reset();
    busy.reset(); // closes the connection, so the picture has no receiver any more
    stopping.server->wait();
    std::_Exit(as_expected);
}

void client_of_a_slow_call() {
    Stopping stopping(enough_to_abandon);
    std::optional<HandMade> busy(*stopping.server);
    busy->send_frame(text, heavy_picture);
    stopping.wait_until_drawing();
    Stopping::signal();
    expect_order(*busy, {"text"}); // the notification server.draining
    std::string last;
    for (std::string got; (got = next(*busy, &last)) != "close 1001";)
        if (got != "text" || last.find("about to stop") == std::string::npos) std::_Exit(1);
    busy.reset();
    stopping.server->wait();
    std::_Exit(as_expected);
}

// With the default of one second the picture may not be abandoned in time; the process then exits with 0. A server that
// waited for the picture would send it, or nothing for longer than the client reads.
void client_of_a_slow_call_by_default() {
    Stopping stopping(1);
    HandMade busy(*stopping.server);
    busy.send_frame(text, heavy_picture);
    stopping.wait_until_drawing();
    Stopping::signal();
    expect_order(busy, {"text"}); // the notification server.draining
    std::string last, got;
    while ((got = next(busy, &last)) == "text")
        if (last.find("about to stop") == std::string::npos) std::_Exit(1);
    const bool is_closed = got == "close 1001" || busy.is_answered(); // else the client has read for too long
    stopping.server->wait();
    std::_Exit(is_closed ? 0 : 1);
}

void client_that_does_not_read() {
    Stopping stopping(1);
    HandMade stuck(*stopping.server, 4096);
    const std::string discover = R"({"jsonrpc":"2.0","id":1,"method":"rpc.discover"})";
    for (int i = 0; i < 150; ++i) stuck.send_frame(text, discover); // more than the socket buffers hold
    stopping.server.reset();
    std::_Exit(as_expected);
}

// The answers fit into the socket buffers, so the server sends its close frame and waits for the client's.
void client_that_does_not_close() {
    Stopping stopping(enough_to_abandon);
    HandMade stuck(*stopping.server);
    stuck.send_frame(text, heavy_picture);
    stopping.wait_until_drawing();
    stopping.server.reset();
    std::_Exit(as_expected);
}

class Drain : public testing::Test {
protected:
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(Drain, AClientAtRestIsToldThoughAnothersCallIsUnderWay) {
    EXPECT_EXIT(idle_client_beside_a_slow_call(), testing::ExitedWithCode(as_expected), "");
}

TEST_F(Drain, ASlowCallIsGivenUpAndItsClientGets1001) {
    EXPECT_EXIT(client_of_a_slow_call(), testing::ExitedWithCode(as_expected), "");
}

TEST_F(Drain, ASlowCallDoesNotHoldUpTheEnd) {
    EXPECT_EXIT(client_of_a_slow_call_by_default(), testing::ExitedWithCode(0), "");
}

TEST_F(Drain, AClientThatDoesNotReadIsCut) {
    EXPECT_EXIT(client_that_does_not_read(), testing::ExitedWithCode(as_expected), "");
}

TEST_F(Drain, AClientThatDoesNotCloseIsCut) {
    EXPECT_EXIT(client_that_does_not_close(), testing::ExitedWithCode(as_expected), "");
}

TEST_F(Drain, TakesASecondWhereNothingElseWasSaid) { EXPECT_EQ(limits::Limits().drain_seconds, 1U); }

} // namespace
} // namespace server::gateway
