// Slow pictures: unwanted ones are abandoned, and no client waits for another client's still.
#include "service.hpp"

#include <gmock/gmock.h>
#include <thread>

namespace ciel::test {
using namespace server;
namespace {

using namespace std::chrono_literals;
using engine::Clock;
using testing::HasSubstr;

// Drawn completely in software, a picture of the heavy scene takes minutes.
constexpr auto soon = 20s;
constexpr int large = 1500;

// Wide transparent lines: many layers to peel, each drawing all lines.
json heavy_scene() {
    return {{"dataset", "box"}, {"layers", {{"lines", {{"type", "edges"}, {"width", 32}, {"opacity", 0.3}}}}}};
}

class GivenUp : public Service {
protected:
    void SetUp() override {
        if (server.draw_test_picture().gl_renderer.find("llvmpipe") == std::string::npos)
            GTEST_SKIP() << "a GPU has drawn these pictures before anybody could give them up";
    }
    struct Opened {
        std::string session;
        json view;
    };
    static Opened open(Client& client, const json& scene, int size, double pixel_ratio = 1) {
        const std::string session = client.call("session.open", {{"scene", scene}})["session"];
        return {session,
                client.call(
                    "view.open",
                    {{"session", session}, {"width", size}, {"height", size}, {"pixel_ratio", pixel_ratio}})["view"]};
    }
    // Opens a view and returns when its first frame is acknowledged and its slow still is being drawn.
    Opened open_with_still_under_way(Client& client, int size = large, double pixel_ratio = 2) {
        Opened opened = open(client, heavy_scene(), size, pixel_ratio);
        client.acknowledge(client.next_frame());
        wait_until_drawing();
        return opened;
    }
    void wait_until_drawing() {
        const auto is_drawing = [this] { return server.frame_workers().busy() + server.picture_workers().busy() > 0; };
        for (auto since = Clock::now(); Clock::now() - since < 300ms; std::this_thread::sleep_for(10ms))
            if (!is_drawing()) since = Clock::now();
    }
    template <class Function>
    static Clock::duration time_of(Function function) {
        const auto start = Clock::now();
        function();
        return Clock::now() - start;
    }
    void expect_workers_free_soon() {
        const auto took = time_of([this] { server.frame_workers().run([](engine::Worker&) { return 0; }); });
        EXPECT_LT(took, soon);
        EXPECT_EQ(server.counters().still_frames(), 0U);
    }

    engine::Server server{options()};
};

TEST_F(GivenUp, a_still_goes_with_its_view) {
    Client client(server, true);
    const Opened opened = open_with_still_under_way(client);
    client.call("view.close", {{"view", opened.view}});
    expect_workers_free_soon();
}

TEST_F(GivenUp, a_still_goes_with_its_connection) {
    {
        Client client(server, true);
        open_with_still_under_way(client);
        server.connection_closed(client.id());
        expect_workers_free_soon();
    }
    Client next(server, true);
    open(next, {{"dataset", "box"}}, 64);
    next.frames_until_still(1);
}

TEST_F(GivenUp, a_still_goes_when_its_scene_changes) {
    Client client(server, true);
    const Opened opened = open_with_still_under_way(client);
    const json remove = {{"layers", {{"lines", nullptr}}}};
    const auto took = time_of([&] {
        client.call("scene.patch", {{"session", opened.session}, {"patch", remove}});
        EXPECT_EQ(client.next_frame().revision, 2U);
    });
    EXPECT_LT(took, soon);
}

TEST_F(GivenUp, a_still_goes_when_the_server_stops) {
    Client client(server, true);
    open_with_still_under_way(client);
    EXPECT_LT(time_of([this] { server.drain(); }), soon);
    EXPECT_EQ(server.counters().still_frames(), 0U);
}

TEST_F(GivenUp, a_picture_goes_with_who_asked_for_it) {
    Client client(server, false);
    auto answer = client.post(
        Client::request_of("picture.render", {{"scene", heavy_scene()}, {"width", 2 * large}, {"height", 2 * large}}));
    wait_until_drawing();
    const auto took = time_of([&] {
        client.hang_up();
        EXPECT_THAT(answer.get(), HasSubstr("the connection ended before the answer"));
    });
    EXPECT_LT(took, soon);
}

TEST_F(GivenUp, a_still_gives_way_to_the_pictures_of_another_view) {
    Client slow(server, true), quick(server, true);
    const auto start = Clock::now();
    open_with_still_under_way(slow, 512, 1);
    open(quick, {{"dataset", "box"}}, 64);
    quick.acknowledge(quick.next_frame());
    EXPECT_EQ(server.counters().still_frames(), 0U)
        << "of the slow one, after " << std::chrono::duration<double>(Clock::now() - start).count();
    EXPECT_NE(slow.next_frame().flags & wire::still, 0U) << "it comes in the end";
}

TEST_F(GivenUp, a_still_does_not_give_way_for_ever) {
    Client slow(server, true), quick(server, true);
    const Opened moved = open(quick, {{"dataset", "box"}}, 64);
    quick.frames_until_still(1);
    open_with_still_under_way(slow, 512, 1);
    auto still = std::async(std::launch::async, [&] { return slow.next_frame().flags & wire::still; });
    int moves = 0;
    while (still.wait_for(0s) != std::future_status::ready) {
        const json patch = {{"background", ++moves % 2 == 0 ? "light" : "dark"}};
        quick.call("scene.patch", {{"session", moved.session}, {"patch", patch}});
        quick.acknowledge(quick.next_frame());
    }
    EXPECT_NE(still.get(), 0U);
    EXPECT_GT(moves, 3);
    EXPECT_THAT(server.metrics(), HasSubstr("ciel_frames_cancelled_total 3\n"));
}

} // namespace
} // namespace ciel::test
