// Socket limits, each set small enough to be reached. No test measures time: when a server ignores its limit, the
// client's receive timeout fails the test.
#include "hand_made.hpp"

#include <gmock/gmock.h>
#include <optional>

namespace server::gateway {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// In seconds. `short_time` is long enough for a correct client on a busy machine.
constexpr unsigned never = 100'000, short_time = 2;

// Limits of time that no test reaches.
limits::Limits patient() {
    limits::Limits limits;
    limits.head_seconds = limits.keep_alive_seconds = limits.request_seconds = limits.websocket_idle_seconds = never;
    return limits;
}
limits::Limits with_request_seconds() {
    limits::Limits limits = patient();
    limits.request_seconds = short_time;
    return limits;
}

const std::string healthz = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
const std::string half_a_header = "GET /healthz HTTP/1.1\r\nHost: local";
const std::string half_a_body =
    "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 900000\r\n"
    "Expect: 100-continue\r\n\r\n{";

const std::string go_on = "HTTP/1.1 100 Continue\r\n\r\n"; // sent by the server after the header of half_a_body

std::string post(const std::string& body) {
    return "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: " +
           std::to_string(body.size()) + "\r\n\r\n" + body;
}

// Sends the byte again and again until the server answers or closes.
void trickle(Socket& socket, const std::string& byte) {
    while (!socket.is_answered())
        if (!socket.send(byte)) return;
}

TEST(RequestBodies, AreCountedWhileTheyArrive) {
    const RunningServer server(patient());
    Socket sender(server), asker(server);
    sender.send(half_a_body);
    EXPECT_EQ(sender.receive(go_on.size()), go_on);
    asker.send("GET /ciel/metrics HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + server.authorization() +
               "\r\n");
    EXPECT_THAT(asker.receive_all(), HasSubstr("ciel_memory_bytes{kind=\"requests\"} 900000\n"));
}

TEST(RequestSeconds, EndARequestThatStops) {
    const RunningServer server(with_request_seconds());
    for (const std::string& begun : {half_a_header, half_a_body}) {
        Socket socket(server);
        socket.send(begun);
        const std::string answer = socket.receive_all();
        EXPECT_THAT(answer, StartsWith((begun == half_a_body ? go_on : "") + "HTTP/1.1 408 "));
        EXPECT_THAT(answer, HasSubstr("Connection: close\r\n")) << begun;
        EXPECT_THAT(answer, HasSubstr("within 2 s")) << begun;
    }
}

TEST(RequestSeconds, EndARequestThatTricklesIn) {
    const RunningServer server(with_request_seconds());
    for (const std::string& begun : {half_a_header, half_a_body}) {
        Socket slow(server);
        slow.send(begun);
        const std::string before = begun == half_a_body ? go_on : "";
        EXPECT_EQ(slow.receive(before.size()), before);
        trickle(slow, "x");
        EXPECT_EQ(slow.receive(13), "HTTP/1.1 408 ") << begun;
    }
}

TEST(RequestSeconds, AreOfEachRequestAndNotOfTheConnection) {
    const RunningServer server(with_request_seconds());
    Socket slow(server), steady(server);
    slow.send(half_a_header);
    for (std::size_t answered = 0; !slow.is_answered(); ++answered) {
        ASSERT_TRUE(steady.send(healthz)) << "closed after " << answered;
        ASSERT_THAT(steady.receive_until("ok\n"), StartsWith("HTTP/1.1 200 ")) << "after " << answered;
    }
}

TEST(RequestSeconds, EndAnAnswerThatIsNotTaken) {
    const RunningServer server(with_request_seconds());
    Socket stuck(server, 4096);
    const std::string discover = post(R"({"jsonrpc":"2.0","id":1,"method":"rpc.discover"})");
    while (stuck.send(discover)) {
    }
}

TEST(HeadSeconds, EndAHeadThatTricklesInAndAConnectionThatNeverBegins) {
    limits::Limits limits = patient();
    limits.head_seconds = short_time;
    const RunningServer server(limits);
    Socket silent(server), slow(server), body(server);
    body.send(half_a_body);
    EXPECT_EQ(body.receive(go_on.size()), go_on);
    slow.send(half_a_header);
    trickle(slow, "x");
    EXPECT_EQ(slow.receive(13), "HTTP/1.1 408 ");
    EXPECT_EQ(silent.receive_all(), "");
    EXPECT_FALSE(body.is_answered()) << "a body has its own time";
}

// A few blank lines are allowed before a request. Sends them byte by byte, so that each line arrives within the time
// limit after the last one. The limit must not start again with each line.
TEST(HeadSeconds, AreNotProlongedByBlankLines) {
    limits::Limits limits = patient();
    limits.head_seconds = short_time;
    const RunningServer server(limits);
    Socket blank(server);
    int sent = 0;
    for (const char byte : std::string("\r\n\r\n\r\n\r\n\r\n\r\n\r\n")) {
        if (blank.is_answered() || !blank.send(std::string(1, byte))) break;
        ++sent;
        std::this_thread::sleep_for(std::chrono::milliseconds(500 * short_time - 100));
    }
    EXPECT_LT(sent, 6) << "the connection was kept from one blank line to the next";
    EXPECT_EQ(blank.receive_all(), "");
}

// Idle and slow connections are closed when new ones need their places.
TEST(Connections, ThatSayNothingMakeRoomForNewOnes) {
    limits::Limits limits = patient();
    limits.connections = 4;
    const RunningServer server(limits);
    std::vector<std::unique_ptr<Socket>> idle;
    for (int i = 0; i < 20; ++i) {
        idle.push_back(std::make_unique<Socket>(server));
        idle.back()->send(half_a_header);
    }
    Socket served(server);
    served.send(healthz);
    EXPECT_EQ(served.receive(13), "HTTP/1.1 200 ");
    EXPECT_EQ(idle.front()->receive_all(), "") << "the oldest was closed";
}

TEST(Connections, OfWebSocketsAndRequestsUnderWayStay) {
    limits::Limits limits = patient();
    limits.connections = 2;
    const RunningServer server(limits);
    HandMade viewer(server);
    Socket busy(server);
    busy.send(half_a_body);
    EXPECT_EQ(busy.receive(go_on.size()), go_on);
    Socket refused(server);
    refused.send(healthz);
    const std::string answer = refused.receive_all();
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 503 "));
    EXPECT_THAT(answer, HasSubstr("Retry-After: 1\r\n"));
    viewer.send_frame(ping, "");
    EXPECT_EQ(viewer.receive_frame().first, pong);
}

// Two of two places are taken, so that further connections are refused.
struct FullServer {
    explicit FullServer(const limits::Limits& limits) : server(limits), viewer(server), busy(server) {
        busy.send(half_a_body);
        EXPECT_EQ(busy.receive(go_on.size()), go_on);
    }
    static limits::Limits limits_of(std::uint64_t linger_seconds) {
        limits::Limits limits = patient();
        limits.connections = 2;
        limits.refused_connections = 1;
        limits.linger_seconds = linger_seconds;
        return limits;
    }
    RunningServer server;
    HandMade viewer;
    Socket busy;
};

TEST(RefusedConnections, GetNoAnswerBeyondTheirNumber) {
    FullServer full(FullServer::limits_of(600));
    Socket refused(full.server);
    refused.send(healthz);
    EXPECT_THAT(refused.receive_all(), StartsWith("HTTP/1.1 503 "));
    Socket another(full.server);
    another.send(healthz);
    EXPECT_EQ(another.receive_all(), "") << "the first refused connection is still open";
}

TEST(LingerSeconds, EndARefusedConnectionThatTheClientKeeps) {
    FullServer full(FullServer::limits_of(short_time));
    Socket refused(full.server);
    refused.send(healthz);
    EXPECT_THAT(refused.receive_all(), StartsWith("HTTP/1.1 503 "));
    std::string answer;
    while (answer.empty()) { // until the server has closed the first
        Socket another(full.server);
        another.send(healthz);
        answer = another.receive_all();
    }
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 503 "));
}

TEST(ReservedFiles, AreNotGivenToConnections) {
    limits::Limits limits = patient();
    limits.reserved_files = 1'000'000; // more than there are
    const RunningServer server(limits);
    Socket refused(server);
    refused.send(healthz);
    EXPECT_EQ(refused.receive_all(), "");
}

TEST(KeepAliveSeconds, EndAConnectionThatSaysNothing) {
    limits::Limits limits = patient();
    limits.keep_alive_seconds = short_time;
    const RunningServer server(limits);
    Socket kept(server), silent(server);
    kept.send(healthz);
    const std::string answer = kept.receive_all();
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 "));
    EXPECT_THAT(answer, testing::EndsWith("ok\n")) << "no second answer";
    EXPECT_EQ(silent.receive_all(), "");
}

TEST(KeepAliveSeconds, DoNotShortenARequest) {
    limits::Limits limits = patient();
    limits.keep_alive_seconds = short_time;
    const RunningServer server(limits);
    Socket silent(server), slow(server);
    slow.send(half_a_header);
    EXPECT_EQ(silent.receive_all(), ""); // the time limit has passed
    slow.send("host\r\n\r\n");
    EXPECT_THAT(slow.receive(13), "HTTP/1.1 200 ");
}

TEST(WebsocketIdleSeconds, EndAConnectionWithoutASignOfLife) {
    limits::Limits limits = patient();
    limits.websocket_idle_seconds = short_time;
    const RunningServer server(limits);
    HandMade silent(server);
    int opcode = 0, pings = 0;
    for (; (opcode = silent.receive_frame().first) >= 0; ++pings) EXPECT_EQ(opcode, ping);
    EXPECT_GT(pings, 0) << "none was asked for";
}

TEST(WebsocketIdleSeconds, PongsAreASignOfLifeEnough) {
    limits::Limits limits;
    // The HTTP limits do not apply to WebSockets.
    limits.keep_alive_seconds = limits.request_seconds = limits.websocket_idle_seconds = short_time;
    const RunningServer server(limits);
    HandMade alive(server);
    for (int beats = 0; beats < 4; ++beats) { // the server sends a ping after each half of the idle time
        const auto [opcode, payload] = alive.receive_frame();
        ASSERT_EQ(opcode, ping) << "after " << beats;
        alive.send_frame(pong, payload);
    }
}

TEST(UnsentBytes, EndAConnectionThatDoesNotReadItsAnswers) {
    limits::Limits limits = patient();
    limits.unsent_bytes = 2000;
    const RunningServer server(limits);
    HandMade stuck(server, 4096);
    while (stuck.send_frame(text, R"({"jsonrpc":"2.0","id":1,"method":"rpc.discover"})")) {
    }
}

TEST(DrainSeconds, EndTheProcessThoughARequestIsUnderWay) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto drain_with_a_request_under_way = [] {
        limits::Limits limits = patient();
        limits.drain_seconds = 1;
        std::optional<RunningServer> server(limits);
        Socket busy(*server);
        busy.send(half_a_body);
        EXPECT_EQ(busy.receive(go_on.size()), go_on);
        server.reset();
        std::_Exit(1); // reached only if the server waits for the request
    };
    EXPECT_EXIT(drain_with_a_request_under_way(), testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace server::gateway
