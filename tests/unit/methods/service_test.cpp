// Rules across methods: only the newest version is drawn, meshes are shared, limits, draining, growing datasets.
#include "service.hpp"

#include "limits/errors.hpp"
#include "store/files/files.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

class Sharing : public Service {};

json iso_scene(double time) {
    return {
        {"dataset", "box"}, {"time", time}, {"layers", {{"iso", {{"type", "iso"}, {"array", "p"}, {"values", {20}}}}}}};
}

json values_patch(double value) { return {{"layers", {{"iso", {{"values", {value}}}}}}}; }

TEST_F(Sharing, of_a_burst_of_patches_at_most_the_first_and_the_last_are_drawn) {
    engine::Server server(options());
    Client client(server, true);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    client.call("view.open", {{"session", session}, {"width", 320}, {"height", 200}});
    client.frames_until_still(1);
    const auto before = server.counters().interactive_frames();

    // Blocks the worker while the burst arrives, as a frame of a large mesh would.
    std::mutex gate;
    std::unique_lock closed(gate);
    for (int i = 0; i < 100; ++i) {
        if (i == 1) server.frame_workers().post([&](engine::Worker&) { const std::scoped_lock open(gate); });
        const json answer = client.call(
            "scene.patch", {{"session", session}, {"patch", values_patch(5 + 0.2 * i)}, {"gesture", "drag"}});
        ASSERT_EQ(answer["revision"], 2 + i) << "every patch is applied, in order";
    }
    closed.unlock();
    const auto frames = client.frames_until_still(101);
    EXPECT_LE(server.counters().interactive_frames() - before, 2U);
    EXPECT_EQ(frames.back().revision, 101U);
    std::uint64_t last = 0;
    for (const auto& frame : frames) {
        EXPECT_GE(frame.revision, last) << "a stale frame";
        last = frame.revision;
    }
    EXPECT_EQ(client.call("scene.undo", {{"session", session}})["can_undo"], false) << "one drag is one step";
}

TEST_F(Sharing, no_more_than_two_frames_wait_for_the_client) {
    engine::Server server(options());
    Client client(server, true);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}});
    const auto first = client.next_frame();
    client.next_frame(); // the next frame is the still
    for (int i = 0; i < 10; ++i) client.call("scene.patch", {{"session", session}, {"patch", values_patch(5 + i)}});
    server.frame_workers().run([](engine::Worker&) { return 0; }); // waits until the queued jobs have run
    EXPECT_EQ(server.counters().interactive_frames() + server.counters().still_frames(), 2U);
    client.acknowledge(first);
    const auto third = client.next_frame();
    EXPECT_EQ(third.frame, 3U);
    EXPECT_EQ(third.revision, 11U) << "what was in between is skipped";
}

TEST_F(Sharing, acknowledgements_of_older_frames_or_of_none_change_nothing) {
    engine::Server server(options());
    Client client(server, true);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}});
    const auto first = client.next_frame(), second = client.next_frame();
    client.acknowledge(second);
    client.acknowledge(first);
    client.call("view.ack", {{"view", first.view}, {"frame", 999}});
    client.call("scene.patch", {{"session", session}, {"patch", values_patch(7)}});
    EXPECT_EQ(client.next_frame().frame, 3U);
    EXPECT_EQ(client.next_frame().frame, 4U) << "there is room for two";
}

TEST_F(Sharing, two_sessions_share_one_topology) {
    engine::Server server(options());
    Client a(server, true), b(server, true);
    const auto topology_of = [&](Client& client) {
        const std::string id = client.call("session.open", {{"dataset", "box"}})["session"];
        client.call("picture.render", {{"session", id}, {"width", 64}, {"height", 64}});
        return server.sessions().find(id)->newest()->checked.loaded()->topology(0);
    };
    EXPECT_EQ(topology_of(a).get(), topology_of(b).get());
}

TEST_F(Sharing, a_session_outlives_its_connections_until_it_has_been_idle) {
    engine::Server server(options());
    std::string id;
    {
        Client client(server, true);
        id = client.call("session.open", {{"dataset", "box"}})["session"];
        server.sessions().expire(engine::Clock::now() + std::chrono::hours(1000));
        EXPECT_NO_THROW((void)server.sessions().find(id)) << "somebody is connected";
    }
    Client later(server, true);
    EXPECT_EQ(later.call("scene.get", {{"session", id}})["session"], id);
    const auto limit = std::chrono::seconds(server.limits().session_idle_seconds);
    server.sessions().expire(engine::Clock::now() + limit - std::chrono::minutes(1));
    EXPECT_NO_THROW((void)server.sessions().find(id));
    server.sessions().expire(engine::Clock::now() + limit + std::chrono::minutes(1));
    EXPECT_THROW((void)server.sessions().find(id), limits::NotFound);
}

// A separate folder with the dataset "run", which one session uses.
class Growing : public testing::Test {
protected:
    Growing() { client.call("session.open", {{"dataset", "run"}}); }
    static engine::ServerOptions options_with(const Folder& folder) {
        write_small_dataset(folder.path() / "run.ciel");
        engine::ServerOptions options;
        options.extraction = chosen_algorithm();
        options.data = {folder.path()};
        return options;
    }
    const Folder own;
    engine::Server server{options_with(own)};
    Client client{server, true};
};

TEST_F(Growing, appended_steps_are_told) {
    append_step(own.path() / "run.ciel", 3);
    const json told = client.next_text();
    EXPECT_EQ(told["method"], "dataset.changed");
    EXPECT_EQ(told["params"]["dataset"], "run");
    EXPECT_EQ(told["params"]["times"], json({0, 1, 2, 3}));
}

TEST_F(Growing, more_times_than_a_message_holds_are_not_told) {
    const std::filesystem::path marker = own.path() / "run.ciel" / "steps.json";
    json document = json::parse(store::read_text(marker, std::size_t{1} << 20));
    for (int step = 3; step < 50'000; ++step) document["steps"].push_back({{"time", step + 0.123456789}, {"mesh", 0}});
    store::replace_file(marker, store::bytes_of(document.dump()));
    const json told = client.next_text();
    EXPECT_EQ(told["method"], "dataset.changed");
    EXPECT_FALSE(told["params"].contains("times"));
    EXPECT_LT(told.dump().size(), 1000U);
}

TEST_F(Growing, a_dataset_that_goes_away_is_told) {
    std::filesystem::rename(own.path() / "run.ciel", own.path() / "elsewhere");
    const json told = client.next_text();
    EXPECT_EQ(told["method"], "dataset.changed");
    EXPECT_EQ(told["params"]["times"], json::array());
    EXPECT_NE(client.error_code("dataset.describe", {{"dataset", "run"}}), 0);
}

TEST_F(Sharing, draining_tells_and_refuses) {
    engine::Server server(options());
    Client client(server, true);
    client.call("session.open", {{"dataset", "box"}});
    server.announce_end();
    server.drain();
    EXPECT_EQ(client.next_text()["method"], "server.draining");
    EXPECT_EQ(client.error_code("session.open", {{"dataset", "box"}}), -32003);
    EXPECT_EQ(client.error_code("picture.render", {{"scene", {{"dataset", "box"}}}}), -32005);
}

TEST_F(Sharing, readiness_draws) {
    engine::Server server(options());
    const frames::TestPictureResult result = server.draw_test_picture();
    EXPECT_TRUE(result.passed) << result.problem;
    EXPECT_FALSE(result.gl_renderer.empty());
    EXPECT_THAT(server.metrics(), testing::HasSubstr("ciel_gl_info{renderer=\"" + result.gl_renderer));
}

TEST_F(Sharing, the_other_algorithm_serves_the_same_pictures) {
    const json params = json::parse(R"({"width": 96, "height": 64, "scene": {"dataset": "box", "layers": {
        "iso": {"type": "iso", "array": "p", "values": [7, 12.5]}, "cut": {"type": "slice", "axis": "z", "value": -47.5}}}})");
    std::vector<std::string> pictures;
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
        auto chosen = options();
        chosen.extraction = algorithm;
        engine::Server server(chosen);
        Client client(server, false);
        pictures.push_back(client.call("picture.render", params)["data"]);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

// Each row of limits.hpp has one test, here or in these files:
// json_rpc_test.cpp: message_bytes, json_depth, batch_requests.
// Above in this file: unacknowledged_frames, session_idle_seconds.
// tests/unit/gateway/test_limits.cpp: limits of sockets. tests/python/test_serve_websocket.py: connections.
// slow_calls_test.cpp: limits of slow calls.
class LimitsOf : public Service {};

TEST_F(LimitsOf, sessions) {
    limits::Limits limits;
    limits.sessions = 2;
    engine::Server server(options(limits));
    Client client(server, true);
    const json first = client.call("session.open", {{"dataset", "box"}});
    client.call("session.open", {{"dataset", "box"}});
    EXPECT_EQ(client.error_code("session.open", {{"dataset", "box"}}), -32003);
    client.call("session.close", {{"session", first["session"]}});
    EXPECT_EQ(client.error_code("session.open", {{"dataset", "box"}}), 0);
}

TEST_F(LimitsOf, sessions_that_were_left_make_room_the_longest_left_first) {
    limits::Limits limits;
    limits.sessions = 2;
    engine::Server server(options(limits));
    std::vector<std::string> left;
    for (int i = 0; i < 2; ++i)
        left.push_back(Client(server, true).call("session.open", {{"dataset", "box"}})["session"]);
    Client client(server, true);
    client.call("session.open", {{"dataset", "box"}});
    EXPECT_THROW((void)server.sessions().find(left[0]), limits::NotFound);
    EXPECT_NO_THROW((void)server.sessions().find(left[1]));
}

TEST_F(LimitsOf, views_layers_values_and_undo_steps_of_a_session) {
    limits::Limits limits;
    limits.views_per_session = 2;
    limits.layers = 4;
    limits.values_per_layer = 3;
    limits.undo_steps = 2;
    engine::Server server(options(limits));
    Client client(server, true);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    const json view{{"session", session}, {"width", 64}, {"height", 64}};
    client.call("view.open", view);
    client.call("view.open", view);
    EXPECT_EQ(client.error_code("view.open", view), -32003);

    json layers;
    for (const char* id : {"a", "b"}) layers[id] = {{"type", "outline"}};
    EXPECT_EQ(client.error_code("scene.patch", {{"session", session}, {"patch", {{"layers", layers}}}}), -32003);
    const auto values = [&](json list) {
        return client.error_code("scene.patch",
                                 {{"session", session}, {"patch", {{"layers", {{"iso", {{"values", list}}}}}}}});
    };
    EXPECT_EQ(values({1, 2, 3, 4}), -32003);
    for (const json& list : {json{1, 2, 3}, json{1, 2}, json{1}}) EXPECT_EQ(values(list), 0);
    client.call("scene.undo", {{"session", session}});
    EXPECT_EQ(client.call("scene.undo", {{"session", session}})["can_undo"], false);
}

TEST_F(LimitsOf, pictures) {
    limits::Limits limits;
    limits.image_side = 200;
    limits.image_pixels = 10'000;
    engine::Server server(options(limits));
    Client client(server, true);
    const auto code = [&](int width, int height) {
        return client.error_code("picture.render",
                                 {{"scene", {{"dataset", "box"}}}, {"width", width}, {"height", height}});
    };
    EXPECT_EQ(code(100, 100), 0);
    EXPECT_EQ(code(201, 20), -32003);
    EXPECT_EQ(code(200, 51), -32003);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    EXPECT_EQ(client.error_code("view.open", {{"session", session}, {"width", 200}, {"height", 51}}), -32003);
    const json view = client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}})["view"];
    EXPECT_EQ(client.error_code("view.resize", {{"view", view}, {"width", 201}, {"height", 20}}), -32003);
}

TEST_F(LimitsOf, histogram_bins_and_export_bytes) {
    limits::Limits limits;
    limits.histogram_bins = 8;
    limits.export_bytes = 100;
    engine::Server server(options(limits));
    Client client(server, false);
    EXPECT_EQ(client.error_code("dataset.histogram", {{"dataset", "box"}, {"array", "p"}, {"bins", 8}}), 0);
    EXPECT_EQ(client.error_code("dataset.histogram", {{"dataset", "box"}, {"array", "p"}, {"bins", 9}}), -32003);
    const json scene{{"dataset", "box"}, {"layers", {{"s", {{"type", "surface"}}}}}};
    EXPECT_EQ(client.error_code("surface.export", {{"scene", scene}, {"layer", "s"}, {"format", "stl"}}), -32003);
}

TEST_F(LimitsOf, memory_of_a_scene_without_a_session) {
    limits::Limits limits;
    limits.session_memory_bytes = 1000;
    engine::Server server(options(limits));
    Client client(server, false);
    const json answer = client.request("picture.render", {{"scene", iso_scene(0)}, {"width", 16}, {"height", 16}});
    EXPECT_EQ(answer["error"]["code"], -32003);
    EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(),
                testing::HasSubstr("show fewer values or layers"));
    EXPECT_EQ(client.error_code("surface.export", {{"scene", iso_scene(0)}, {"layer", "iso"}, {"format", "stl"}}),
              -32003);
    EXPECT_EQ(client.error_code("picture.render", {{"scene", {{"dataset", "box"}}}}), 0);
}

class DatasetsInMemory : public LimitsOf {
protected:
    static void look_at(Client& client, const char* dataset) {
        json scene = iso_scene(0);
        scene["dataset"] = dataset;
        (void)client.call("picture.render", {{"scene", scene}, {"width", 16}, {"height", 16}});
    }
    static bool counts(const engine::Server& server, int datasets) {
        return server.metrics().find("ciel_datasets " + std::to_string(datasets) + "\n") != std::string::npos;
    }
};

TEST_F(DatasetsInMemory, are_counted_without_a_session_and_given_back_when_idle) {
    limits::Limits limits;
    limits.dataset_idle_seconds = 100;
    engine::Server server(options(limits));
    Client client(server, false);
    EXPECT_TRUE(counts(server, 0));
    look_at(client, "box");
    look_at(client, "bax");
    EXPECT_TRUE(counts(server, 2));
    EXPECT_THAT(server.metrics(), testing::Not(testing::HasSubstr("ciel_dataset_bytes 0\n")));
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    server.tidy(engine::Clock::now() + std::chrono::seconds(90));
    EXPECT_TRUE(counts(server, 2));
    server.tidy(engine::Clock::now() + std::chrono::seconds(110));
    EXPECT_TRUE(counts(server, 1)) << "a session shows box";
}

TEST_F(DatasetsInMemory, are_given_back_beyond_dataset_memory_bytes) {
    limits::Limits limits;
    limits.dataset_memory_bytes = 1;
    engine::Server server(options(limits));
    Client client(server, false);
    look_at(client, "box");
    look_at(client, "bax");
    server.tidy(engine::Clock::now());
    EXPECT_TRUE(counts(server, 1));
}

TEST_F(LimitsOf, field_cache_bytes) {
    const auto kept_with = [](std::size_t bytes) {
        limits::Limits limits;
        limits.field_cache_bytes = bytes;
        engine::Server server(options(limits));
        Client client(server, false);
        const auto loaded = server.catalog().open("box");
        (void)client.call("picture.render", {{"scene", iso_scene(0)}, {"width", 16}, {"height", 16}});
        const std::size_t first = loaded->memory_bytes();
        for (const int time : {1, 2})
            (void)client.call("picture.render", {{"scene", iso_scene(time)}, {"width", 16}, {"height", 16}});
        return loaded->memory_bytes() - first;
    };
    EXPECT_GT(kept_with(1 << 30), 0U);
    EXPECT_EQ(kept_with(1), 0U) << "the fields of one step make room for those of the next";
}

TEST_F(LimitsOf, memory_of_a_session) {
    limits::Limits limits;
    limits.session_memory_bytes = 1000;
    engine::Server server(options(limits));
    Client client(server, true);
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    EXPECT_EQ(client.error_code("picture.render", {{"session", session}}), -32003);
    client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}});
    const json failed = client.next_text();
    EXPECT_EQ(failed["method"], "view.failed");
    EXPECT_EQ(failed["params"]["revision"], 1);
    EXPECT_THAT(failed["params"]["message"].get<std::string>(), testing::HasSubstr("show fewer values or layers"));
    client.call("scene.patch",
                {{"session", session}, {"patch", {{"layers", {{"iso", nullptr}, {"surface", nullptr}}}}}});
    EXPECT_EQ(client.error_code("picture.render", {{"session", session}}), 0) << "it goes on with a smaller scene";
}

} // namespace
} // namespace ciel::test
