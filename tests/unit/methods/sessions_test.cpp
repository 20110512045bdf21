// Sessions: opening, patching, undo, notifications to subscribers.
#include "methods.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

TEST_F(Methods, a_session_is_opened_joined_recreated_and_closed) {
    const json first = client.call("scene.get", in_session({}));
    EXPECT_EQ(first["revision"], 1);
    EXPECT_EQ(first["can_undo"], false);
    EXPECT_EQ(client.call("session.open", in_session({{"dataset", "bax"}})), first) << "joined, not replaced";
    client.call("session.close", in_session({}));
    EXPECT_EQ(client.error_code("scene.get", in_session({})), -32001);
    const json again = client.call("session.open", in_session({{"scene", colored_scene}}));
    EXPECT_EQ(again["session"], session);
    EXPECT_EQ(again["scene"], colored_scene);
    EXPECT_NE(client.call("session.open")["session"], session);
}

TEST_F(Methods, patch_undo_redo_and_gestures) {
    const auto patch = [&](double value, const char* gesture) {
        return client.call("scene.patch", in_session({{"patch", {{"layers", {{"iso", {{"values", {value}}}}}}}},
                                                      {"gesture", gesture}}));
    };
    const auto value = [&] { return client.call("scene.get", in_session({}))["scene"]["layers"]["iso"]["values"][0]; };
    const json before = value();
    EXPECT_EQ(patch(5, "a")["revision"], 2);
    EXPECT_EQ(patch(6, "a")["revision"], 3);
    EXPECT_EQ(patch(7, "b")["revision"], 4);
    EXPECT_EQ(patch(7, "b")["revision"], 4) << "nothing changed";
    EXPECT_EQ(client.call("scene.undo", in_session({}))["revision"], 5);
    EXPECT_EQ(value(), 6);
    EXPECT_EQ(client.call("scene.undo", in_session({}))["can_undo"], false);
    EXPECT_EQ(value(), before);
    client.call("scene.redo", in_session({}));
    EXPECT_EQ(client.call("scene.redo", in_session({}))["can_redo"], false);
    EXPECT_EQ(value(), 7);
    client.call("dataset.open", in_session({{"dataset", "bax"}}));
    EXPECT_EQ(client.call("scene.get", in_session({}))["scene"]["dataset"], "bax");
    EXPECT_EQ(client.call("scene.undo", in_session({}))["scene"]["dataset"], "box");
}

TEST_F(Methods, a_session_is_begun_with_the_steps_that_a_client_has_kept) {
    const json scene{{"dataset", "box"}, {"time", 2}};
    json params{{"session", "restarted-server-session"}, {"scene", scene}};
    params["undo"] = json::parse(R"([{"time": 1}, {"time": null}])");
    params["redo"] = json::parse(R"([{"background": "light"}])");
    const json opened = client.call("session.open", params);
    EXPECT_EQ(opened["can_undo"], true);
    EXPECT_EQ(opened["can_redo"], true);
    const json id{{"session", opened["session"]}};
    EXPECT_EQ(client.call("scene.undo", id)["scene"]["time"], 1);
    const json oldest = client.call("scene.undo", id);
    EXPECT_FALSE(oldest["scene"].contains("time"));
    EXPECT_EQ(oldest["can_undo"], false);
    for (int i = 0; i < 2; ++i) (void)client.call("scene.redo", id);
    const json newest = client.call("scene.redo", id);
    EXPECT_EQ(newest["scene"], json({{"dataset", "box"}, {"time", 2}, {"background", "light"}}));
    EXPECT_EQ(newest["can_redo"], false);

    // Opening an existing session ignores the undo steps in the request; the session keeps its history.
    params["undo"] = json::parse(R"([{"time": 0.5}])");
    (void)client.call("session.open", params);
    EXPECT_EQ(client.call("scene.undo", id)["scene"], scene);
}

TEST_F(Methods, an_undo_passes_over_what_cannot_be_shown_any_more) {
    const test::Folder aside;
    write_small_dataset(folder->path() / "gone.ciel");
    client.call("dataset.open", in_session({{"dataset", "gone"}}));
    client.call("dataset.open", in_session({{"dataset", "bax"}}));
    std::filesystem::rename(folder->path() / "gone.ciel", aside.path() / "gone.ciel");
    client.call("dataset.list"); // makes the server read the folder again
    const json undone = client.call("scene.undo", in_session({}));
    EXPECT_EQ(undone["scene"]["dataset"], "box");
    EXPECT_EQ(undone["can_undo"], false);
    EXPECT_EQ(client.call("scene.redo", in_session({}))["scene"]["dataset"], "bax");
}

TEST_F(Methods, a_patch_that_breaks_the_scene_changes_nothing) {
    const json before = client.call("scene.get", in_session({}));
    for (const char* patch : {R"({"layers": {"iso": {"array": "nope"}}})", R"({"dataset": null})",
                              R"({"layers": {"iso": {"values": 3}}})", R"({"camera": {"position": [0, 0]}})"}) {
        const json answer = client.request("scene.patch", in_session({{"patch", json::parse(patch)}}));
        EXPECT_EQ(answer["error"]["code"], -32002) << patch;
        EXPECT_FALSE(answer["error"]["data"]["path"].get<std::string>().empty()) << patch;
    }
    EXPECT_EQ(client.error_code("scene.patch", in_session({{"patch", {{"dataset", "nope"}}}})), -32001);
    EXPECT_EQ(client.call("scene.get", in_session({})), before);
}

TEST_F(Methods, others_in_a_session_hear_of_changes_and_the_author_does_not) {
    Client other(server, true);
    other.call("session.open", in_session({}));
    client.call("scene.patch", in_session({{"patch", {{"annotations", {{"legend", false}}}}}}));
    const json heard = other.next_text();
    EXPECT_EQ(heard["method"], "scene.changed");
    EXPECT_EQ(heard["params"]["session"], session);
    EXPECT_EQ(heard["params"]["revision"], 2);
    EXPECT_EQ(heard["params"]["scene"], client.call("scene.get", in_session({}))["scene"]);
    other.call("scene.patch", in_session({{"patch", {{"annotations", {{"legend", true}}}}}}));
    EXPECT_EQ(client.next_text()["params"]["revision"], 3) << "the first it hears is the other's change";
}

// Layers larger than a message: hidden volumes, each with the maximal number of opacity points.
json long_layers() {
    json points = json::array();
    for (int i = 0; i < 256; ++i) points.push_back({i / 255.0, 1.0 / (i + 3)});
    json layers = json::object();
    for (int i = 0; i < 60; ++i)
        layers["volume" + std::to_string(i)] = {
            {"type", "volume"}, {"array", "p"}, {"visible", false}, {"opacity_points", points}};
    return layers;
}

TEST_F(Methods, a_change_too_long_for_a_message_is_told_without_the_scene) {
    Client other(server, true), script(server, false);
    other.call("session.open", in_session({}));
    client.call("scene.patch", in_session({{"patch", {{"layers", long_layers()}}}}));
    const json heard = other.next_text();
    EXPECT_EQ(heard["method"], "scene.changed");
    EXPECT_EQ(heard["params"]["revision"], 2);
    EXPECT_FALSE(heard["params"].contains("scene"));
    EXPECT_EQ(other.error_code("scene.get", in_session({})), -32006);
    EXPECT_EQ(script.call("scene.get", in_session({}))["revision"], 2);
}

TEST_F(Methods, an_answer_too_long_for_a_message_is_refused_on_a_websocket_and_given_to_a_post) {
    const json params = in_session({});
    client.call("scene.patch", in_session({{"patch", {{"layers", long_layers()}}}}));
    const json refused = client.request("scene.get", params);
    EXPECT_EQ(refused["error"]["code"], -32006);
    EXPECT_NE(refused["error"]["data"]["reason"].get<std::string>().find("send the call with POST /rpc"),
              std::string::npos);
    Client script(server, false);
    EXPECT_GT(script.call("scene.get", params).dump().size(), wire::longest_message);
    json batch{Client::request_of("server.info", json::object()), Client::request_of("scene.get", params)};
    batch[0]["id"] = "first";
    const std::string text = client.send(batch.dump());
    EXPECT_LT(text.size(), wire::longest_message);
    EXPECT_EQ(json::parse(text)[0]["id"], "first");
    EXPECT_EQ(json::parse(text)[0]["error"]["code"], -32006);
    EXPECT_FALSE(json::parse(text)[0]["error"]["data"]["request"].get<std::string>().empty());
}

TEST_F(Methods, an_answer_is_not_too_long_because_of_its_ids) {
    json one = Client::request_of("server.info", json::object()), batch = json::array();
    one["id"] = std::string(600'000, 'i');
    for (int i = 0; i < 60; ++i) {
        batch.push_back(Client::request_of("server.info", json::object()));
        batch.back()["id"] = std::string(15'000, 'i');
    }
    for (const json& sent : {one, batch}) {
        const std::string text = client.send(sent.dump());
        EXPECT_LT(text.size(), wire::longest_message);
        EXPECT_EQ(json::parse(text)["id"], nullptr);
        EXPECT_EQ(json::parse(text)["error"]["code"], -32006);
    }
    Client script(server, false);
    EXPECT_EQ(json::parse(script.send(one.dump()))["id"], one["id"]);
}

} // namespace
} // namespace ciel::test
