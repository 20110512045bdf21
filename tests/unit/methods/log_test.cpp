// Log lines about calls, sessions and drawing, and the ids that relate them to a client's answers.
#include "logging/log.hpp"
#include "service.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <sstream>
#include <thread>

namespace ciel::test {
using namespace server;
namespace {

using testing::HasSubstr;
using testing::Not;

class Logged : public Service {
protected:
    void SetUp() override {
        testing::internal::CaptureStderr();
        logging::start_log("info", logging::LogFormat::json);
    }
    void TearDown() override {
        if (capturing) (void)end();
        logging::start_log("off", logging::LogFormat::text);
    }
    std::vector<json> end() { // stops capturing and returns all lines so far
        capturing = false;
        std::istringstream lines(whole = testing::internal::GetCapturedStderr());
        std::vector<json> events;
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with('{')) events.push_back(json::parse(line)); // other lines are Mesa's
        return events;
    }
    static std::vector<json> of(const std::vector<json>& events, const std::string& name) {
        std::vector<json> found;
        std::copy_if(events.begin(), events.end(), std::back_inserter(found),
                     [&](const json& event) { return event["event"] == name; });
        return found;
    }

    bool capturing = true;
    std::string whole;
};

TEST_F(Logged, a_failed_call_has_one_line_with_the_id_that_the_client_sees) {
    engine::Server server(options());
    Client client(server, false);
    const std::string id(32, 'f');
    const json unknown = client.request("scene.get", {{"session", id}});
    const json wrong = client.request("scene.get", {{"session", 5}});
    const json text = json::parse(client.send("{"));
    (void)client.call("server.info");
    const auto lines = of(end(), "call failed");
    ASSERT_EQ(lines.size(), 3U) << whole;
    EXPECT_EQ(lines[0]["method"], "scene.get");
    EXPECT_EQ(lines[0]["code"], -32001);
    EXPECT_EQ(lines[0]["request"], unknown["error"]["data"]["request"]);
    EXPECT_EQ(lines[0]["session"], "ffffffff");
    EXPECT_TRUE(lines[0]["ms"].is_number());
    EXPECT_EQ(lines[1]["request"], wrong["error"]["data"]["request"]);
    EXPECT_EQ(lines[2]["request"], text["error"]["data"]["request"]);
    EXPECT_NE(lines[0]["request"], lines[1]["request"]);
    EXPECT_THAT(whole, Not(HasSubstr(id))) << "a session's id is its key";
}

TEST_F(Logged, sessions_are_opened_and_closed_without_their_key) {
    limits::Limits limits;
    limits.session_idle_seconds = 1;
    engine::Server server(options(limits));
    std::string closed, left;
    {
        Client client(server, true);
        closed = client.call("session.open", {{"dataset", "box"}})["session"];
        left = client.call("session.open", {{"dataset", "bax"}})["session"];
        client.call("session.open", {{"session", left}}); // joins the session
        client.call("session.close", {{"session", closed}});
    }
    server.tidy(engine::Clock::now() + std::chrono::hours(1));
    const auto events = end();
    const auto opened = of(events, "session opened"), ended = of(events, "session closed");
    ASSERT_EQ(opened.size(), 2U) << whole;
    EXPECT_EQ(opened[0]["dataset"], "box");
    EXPECT_EQ(opened[0]["session"], closed.substr(0, 8));
    ASSERT_EQ(ended.size(), 2U) << whole;
    EXPECT_EQ(ended[0]["session"], closed.substr(0, 8));
    EXPECT_EQ(ended[0]["why"], "by a client");
    EXPECT_EQ(ended[1]["session"], left.substr(0, 8));
    EXPECT_EQ(ended[1]["why"], "idle");
    EXPECT_TRUE(ended[1]["seconds"].is_number());
    for (const auto& id : {closed, left}) EXPECT_THAT(whole, Not(HasSubstr(id)));
}

TEST_F(Logged, a_frame_that_fails_has_a_line) {
    limits::Limits limits;
    limits.session_memory_bytes = 1000;
    engine::Server server(options(limits));
    Client client(server, true);
    const std::string session = client.call("session.open", {{"dataset", "box"}})["session"];
    client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}});
    const json told = client.next_text();
    client.call("scene.patch", {{"session", session}, {"patch", {{"background", "#ffffff"}}}});
    const json told_again = client.next_text();
    const auto events = end();
    const auto lines = of(events, "frame failed"), opened = of(events, "session opened");
    ASSERT_GE(lines.size(), 1U) << whole;
    EXPECT_EQ(lines[0]["request"], opened[0]["request"]) << "the request that made the scene";
    EXPECT_EQ(told["params"]["request"], opened[0]["request"]);
    EXPECT_NE(told_again["params"]["request"], told["params"]["request"]);
    EXPECT_EQ(lines[0]["reason"], told["params"]["message"]);
    EXPECT_EQ(lines[0]["session"], session.substr(0, 8));
}

TEST_F(Logged, a_call_that_waits_for_long_is_called_slow) {
    engine::Server server(options());
    Client client(server, false);
    // server.info draws the first test picture. The worker is blocked, so the call is slow.
    server.frame_workers().post([](engine::Worker&) { std::this_thread::sleep_for(std::chrono::milliseconds(1100)); });
    (void)client.call("server.info");
    const auto lines = of(end(), "slow call");
    ASSERT_EQ(lines.size(), 1U) << whole;
    EXPECT_EQ(lines[0]["method"], "server.info");
    EXPECT_GE(lines[0]["ms"].get<double>(), 1000);
    EXPECT_FALSE(lines[0]["request"].get<std::string>().empty());
}

TEST_F(Logged, a_frame_that_takes_long_is_called_slow) {
    std::string session;
    json view;
    {
        engine::Server server(options());
        if (server.draw_test_picture().gl_renderer.find("llvmpipe") == std::string::npos)
            GTEST_SKIP() << "a graphics card draws such frames too fast";
        double milliseconds = 0;
        for (int layers = 2; milliseconds < 1000; layers *= 3) {
            ASSERT_LT(layers, 500) << "no frame was slow";
            json scene = {{"dataset", "box"}};
            for (int i = 0; i < layers; ++i)
                scene["layers"]["lines" + std::to_string(i)] = {{"type", "edges"}, {"width", 32}, {"opacity", 0.3}};
            Client client(server, true);
            session = client.call("session.open", {{"scene", scene}})["session"];
            view = client.call("view.open", {{"session", session}, {"width", 4000}, {"height", 4000}})["view"];
            const wire::FrameHeader frame = client.next_frame();
            milliseconds = frame.extract_ms + frame.draw_ms + frame.encode_ms;
        }
    } // the line is written after the frame is sent
    const auto lines = of(end(), "slow frame");
    ASSERT_GE(lines.size(), 1U) << whole;
    EXPECT_EQ(lines.back()["session"], session.substr(0, 8));
    EXPECT_EQ(lines.back()["view"], view);
    EXPECT_FALSE(lines.back()["request"].get<std::string>().empty());
    EXPECT_GE(lines.back()["ms"].get<double>(), 1000);
}

class TestPicture : public Service {};

TEST_F(TestPicture, is_told_from_the_last_result_while_the_worker_draws_for_others) {
    engine::Server server(options());
    ASSERT_TRUE(server.draw_test_picture().passed);
    std::promise<void> gate;
    server.frame_workers().post([opened = gate.get_future().share()](engine::Worker&) { opened.wait(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // longer than a result stays valid
    auto answer = std::async(std::launch::async, [&] { return server.test_picture_by_now(); });
    EXPECT_EQ(answer.wait_for(std::chrono::seconds(20)), std::future_status::ready) << "it waits for the worker";
    gate.set_value();
    EXPECT_TRUE(answer.get().passed);
}

TEST_F(TestPicture, fails_if_a_worker_hangs) {
    limits::Limits impatient;
    impatient.hang_seconds = 1;
    engine::Server server(options(impatient));
    ASSERT_TRUE(server.draw_test_picture().passed);
    std::promise<void> gate;
    server.frame_workers().post([opened = gate.get_future().share()](engine::Worker&) { opened.wait(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // longer than a result stays valid
    EXPECT_TRUE(server.test_picture_by_now().passed) << "the worker may be busy";
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    const frames::TestPictureResult result = server.test_picture_by_now();
    EXPECT_FALSE(result.passed);
    EXPECT_THAT(result.problem, HasSubstr("has not answered for 1 s"));
    gate.set_value();
}

TEST_F(TestPicture, fails_if_one_of_two_workers_hangs) {
    limits::Limits impatient;
    impatient.hang_seconds = 1;
    engine::ServerOptions two = options(impatient);
    two.render_workers = 2;
    engine::Server server(std::move(two));
    ASSERT_TRUE(server.draw_test_picture().passed);
    std::promise<void> gate;
    server.frame_workers().post([opened = gate.get_future().share()](engine::Worker&) { opened.wait(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // longer than a result stays valid
    (void)server.test_picture_by_now();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    EXPECT_FALSE(server.test_picture_by_now().passed);
    gate.set_value();
}

TEST_F(TestPicture, ends_where_nothing_is_drawn_any_more) {
    engine::Server server(options());
    ASSERT_TRUE(server.draw_test_picture().passed);
    server.drain();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    const frames::TestPictureResult result = server.test_picture_by_now();
    EXPECT_FALSE(result.passed);
    EXPECT_THAT(result.problem, HasSubstr("about to stop"));
}

} // namespace
} // namespace ciel::test
