// Slow calls, for example pictures and exports, while the frame worker is busy.
#include "service.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

using testing::HasSubstr;

class Slow : public Service {
protected:
    static limits::Limits limits() {
        limits::Limits made;
        made.slow_calls = 1;
        made.slow_calls_waiting = 2;
        return made;
    }
    Slow() {
        (void)server.draw_test_picture();
        gate.lock();
        server.picture_workers().post([this](engine::Worker&) { const std::scoped_lock open(gate); });
    }
    ~Slow() override { open(); }
    void open() {
        if (std::exchange(closed, false)) gate.unlock();
    }
    static json picture() {
        return Client::request_of("picture.render", {{"scene", {{"dataset", "box"}}}, {"width", 16}, {"height", 16}});
    }
    [[nodiscard]] std::string reason(std::future<std::string>& answer) const {
        return json::parse(answer.get())["error"]["data"]["reason"];
    }
    void wait_until_running() {
        while (server.slow_calls().running() == 0) std::this_thread::yield();
    }
    [[nodiscard]] bool drew_nothing() const {
        return server.metrics().find("ciel_pictures_total 0\n") != std::string::npos;
    }

    std::mutex gate; // blocks the worker while locked
    bool closed = true;
    engine::Server server{options(limits())};
};

TEST_F(Slow, quick_methods_do_not_wait_for_slow_ones) {
    Client client(server, true), scripts(server, false);
    auto first = scripts.post(picture()), second = scripts.post(picture());
    for (Client* each : {&client, &scripts}) {
        EXPECT_EQ(each->call("server.info")["gl_renderer"], server.last_test_picture().gl_renderer);
        EXPECT_EQ(each->call("dataset.list").size(), 2U);
        const std::string session = each->call("session.open", {{"dataset", "box"}})["session"];
        EXPECT_EQ(each->error_code("scene.patch", {{"session", session}, {"patch", {{"background", "light"}}}}), 0);
        if (each == &scripts) continue;
        client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}});
        client.frames_until_still(2);
    }
    EXPECT_TRUE(server.draw_test_picture().passed);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // longer than a result stays valid
    EXPECT_TRUE(server.test_picture_by_now().passed);
    EXPECT_TRUE(drew_nothing());
    open();
    EXPECT_THAT(first.get(), HasSubstr("image/png"));
    EXPECT_THAT(second.get(), HasSubstr("image/png"));
}

TEST_F(Slow, too_many_are_refused_with_what_to_do) {
    Client client(server, false);
    auto under_way = client.post(picture());
    wait_until_running();
    auto first = client.post(picture()), second = client.post(picture()), third = client.post(picture());
    EXPECT_THAT(reason(third), HasSubstr("try again in a few seconds"));
    open();
    for (auto* each : {&under_way, &first, &second}) EXPECT_THAT(each->get(), HasSubstr("image/png"));
}

TEST_F(Slow, the_end_of_the_connection_ends_what_runs_and_what_waits) {
    Client client(server, false);
    auto running = client.post(picture());
    wait_until_running();
    auto waiting = client.post(picture());
    client.hang_up();
    EXPECT_THAT(reason(waiting), HasSubstr("the connection has ended"));
    open();
    EXPECT_THAT(reason(running), HasSubstr("the connection ended before the answer"));
    EXPECT_TRUE(drew_nothing());
}

TEST_F(Slow, a_batch_ends_with_its_connection) {
    Client client(server, false), other(server, false);
    json batch = json::array();
    for (int i = 0; i < 5; ++i) batch.push_back(picture());
    auto answers = client.post(batch);
    wait_until_running();
    client.hang_up();
    open();
    for (const json& answer : json::parse(answers.get()))
        EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("connection"));
    EXPECT_TRUE(drew_nothing());
    EXPECT_THAT(other.post(picture()).get(), HasSubstr("image/png"));
}

TEST_F(Slow, a_batch_is_answered_in_order_though_it_waits_for_each_turn) {
    Client client(server, false);
    const std::string session = client.call("session.open", {{"dataset", "box"}})["session"];
    json batch = json::array();
    for (int i = 0; i < 3; ++i) {
        batch.push_back(Client::request_of("picture.render", {{"session", session}, {"width", 16}, {"height", 16}}));
        batch.push_back(Client::request_of(
            "scene.patch", {{"session", session}, {"patch", {{"background", i % 2 == 0 ? "light" : "dark"}}}}));
    }
    auto waiting = client.post(batch);
    open();
    const json answers = json::parse(waiting.get());
    ASSERT_EQ(answers.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(answers[i]["result"]["revision"], 1 + (i + 1) / 2) << i;
}

TEST_F(Slow, draining_answers_what_waits) {
    Client client(server, false);
    auto running = client.post(picture());
    wait_until_running();
    auto waiting = client.post(picture());
    std::jthread draining([&] { server.drain(); });
    EXPECT_THAT(reason(waiting), HasSubstr("about to stop"));
    open();
    EXPECT_THAT(running.get(), HasSubstr("image/png")) << "what is under way is finished";
}

} // namespace
} // namespace ciel::test
