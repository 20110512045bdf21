// Every method at least once, on a real dataset with a real renderer.
#include "service.hpp"

#include <cmath>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>

namespace ciel::test {
namespace {

class Methods : public Service {
protected:
    session::Server server{options()};
    Client client{server, true};
    std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    json in_session(json params) {
        params["session"] = session;
        return params;
    }
};

const json colored_scene = json::parse(
    R"({"dataset": "box", "layers": {"iso": {"type": "iso", "array": "p", "values": [12], "color": {"array": "U:x"}}}})");

std::string decoded(const std::string& text) {
    static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const std::size_t digit = alphabet.find(c);
        if (digit == std::string::npos) throw std::runtime_error("not base64: " + text.substr(0, 100));
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
    }
    return bytes;
}

TEST_F(Methods, discover_is_the_contract_and_all_its_methods_exist) {
    const json document = client.call("rpc.discover");
    std::ifstream contract(CIEL_SOURCE_DIR "/protocol/openrpc.json");
    EXPECT_EQ(document, json::parse(contract));
    ASSERT_FALSE(document["methods"].empty());
    for (const json& method : document["methods"])
        EXPECT_NE(client.error_code(method["name"], {{"no such param", 1}}), -32601) << method["name"];
}

TEST_F(Methods, server_info) {
    const json info = client.call("server.info");
    EXPECT_FALSE(info["gl_renderer"].get<std::string>().empty());
    EXPECT_EQ(info["engine"], chosen_engine() == Engine::propagation ? "propagation" : "signatures");
    const session::Limits& limits = server.limits();
    EXPECT_EQ(info["limits"].size(), session::limit_rows().size());
    for (const auto& row : session::limit_rows()) EXPECT_EQ(info["limits"][row.name], limits.*row.member) << row.name;
    EXPECT_THAT(info["color_maps"], testing::Contains("viridis"));
}

TEST_F(Methods, dataset_describe) {
    const json box = client.call("dataset.describe", {{"dataset", "box"}});
    EXPECT_EQ(box["times"], json({0, 1, 2}));
    EXPECT_EQ(box["bounds"], json({1000, 1006, 0, 6, -50, -44}));
    EXPECT_EQ(box["length_units"], "m");
    std::map<std::string, json> arrays;
    for (const json& array : box["arrays"]) arrays[array["name"]] = array;
    EXPECT_EQ(arrays.size(), 4U);
    EXPECT_EQ(arrays["p"]["range"], json::array({0, 56})); // over all steps
    EXPECT_EQ(arrays["U"]["scalars"].size(), 4U);
    EXPECT_TRUE(arrays["cell:q"]["scalars"].empty());
    EXPECT_EQ(arrays["late"]["times"], json::array({2}));
    EXPECT_EQ(box["groups"].size(), 3U);
    EXPECT_GT(box["mesh"]["half_edges"], 1000);
    EXPECT_EQ(box["default_scene"]["dataset"], "box");
    EXPECT_EQ(client.error_code("dataset.describe", {{"dataset", "../box"}}), -32001);
    EXPECT_EQ(client.error_code("dataset.describe", {{"dataset", "/etc/passwd"}}), -32001);
}

TEST_F(Methods, histogram_counts_every_vertex_once) {
    const json vertices = client.call("dataset.describe", {{"dataset", "box"}})["mesh"]["vertices"];
    json params{{"dataset", "box"}, {"array", "p"}, {"bins", 10}};
    const auto total = [](const json& h) {
        int sum = h["invalid"].get<int>() + h["below"].get<int>() + h["above"].get<int>();
        for (const json& count : h["counts"]) sum += count.get<int>();
        return sum;
    };
    const json all = client.call("dataset.histogram", params);
    EXPECT_EQ(all["range"], json({0, 36}));
    EXPECT_EQ(total(all), vertices);
    EXPECT_EQ(all["below"], 0);
    EXPECT_EQ(all["above"], 0);
    params["range"] = {10, 20};
    const json part = client.call("dataset.histogram", params);
    EXPECT_EQ(total(part), vertices);
    EXPECT_GT(part["below"], 0);
    EXPECT_GT(part["above"], 0);
    params["range"] = {-1.5e308, 1.5e308};
    EXPECT_EQ(client.call("dataset.histogram", params)["counts"][5], vertices) << "all lie just above the middle";
    params["range"] = {20, 10};
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32602);
    params["array"] = "nope";
    params.erase("range");
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32001);
    params["array"] = "late"; // not written at the first time
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32005);
}

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

    // One that exists keeps its own.
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
    client.call("dataset.list"); // looks at the folder
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

// A scene of more than a message: hidden volumes with as many opacity points as they may have.
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
    EXPECT_NE(refused["error"]["data"]["reason"].get<std::string>().find("ask by POST /rpc"), std::string::npos);
    Client script(server, false);
    EXPECT_GT(script.call("scene.get", params).dump().size(), wire::longest_message);
    json batch{Client::request_of("server.info", json::object()), Client::request_of("scene.get", params)};
    batch[0]["id"] = "first";
    const std::string text = client.send(batch.dump());
    EXPECT_LT(text.size(), wire::longest_message);
    EXPECT_EQ(json::parse(text)[0]["id"], "first");
    EXPECT_EQ(json::parse(text)[0]["error"]["code"], -32006);
}

TEST_F(Methods, views_stream_pictures_that_are_refined) {
    const auto view =
        client.call("view.open", in_session({{"width", 320}, {"height", 200}}))["view"].get<std::uint32_t>();
    const wire::FrameHeader first = client.next_frame();
    EXPECT_EQ(first.view, view);
    EXPECT_EQ(first.frame, 1U);
    EXPECT_EQ(first.revision, 1U);
    EXPECT_EQ(first.kind, wire::FrameKind::image);
    EXPECT_EQ(first.flags & wire::still, 0);
    EXPECT_EQ(first.flags & (wire::first_of_frame | wire::last_of_frame), wire::first_of_frame | wire::last_of_frame);
    client.acknowledge(first);
    const auto message = client.next_message();
    const wire::FrameHeader still = wire::read_frame_header(*message);
    EXPECT_EQ(still.flags & wire::still, wire::still);
    EXPECT_EQ(still.frame, 2U);
    EXPECT_EQ(still.width, 320U);
    EXPECT_EQ(message->size(), wire::frame_header_bytes + still.payload_bytes);
    EXPECT_EQ(
        std::string(message->begin() + wire::frame_header_bytes + 1, message->begin() + wire::frame_header_bytes + 4),
        "PNG");
    EXPECT_GT(still.triangles, 0U);
    client.acknowledge(still);

    client.call("view.resize", {{"view", view}, {"width", 2560}, {"height", 1440}});
    const auto resized = client.frames_until_still(1);
    EXPECT_EQ(resized.front().width, 1280U) << "interactive pictures stay small";
    EXPECT_EQ(resized.back().width, 2560U);
    client.call("view.close", {{"view", view}});
    EXPECT_EQ(client.error_code("view.close", {{"view", view}}), -32001);
}

TEST_F(Methods, a_view_belongs_to_its_connection) {
    const json view = client.call("view.open", in_session({{"width", 64}, {"height", 64}}))["view"];
    Client other(server, true);
    EXPECT_EQ(other.error_code("view.close", {{"view", view}}), -32001);
    Client script(server, false);
    EXPECT_EQ(script.error_code("view.open", in_session({{"width", 64}, {"height", 64}})), -32004);
}

TEST_F(Methods, geometry_is_sent_once_for_any_camera) {
    client.call("view.open", in_session({{"width", 64}, {"height", 64}, {"stream", "geometry"}}));
    wire::FrameHeader header = client.next_frame();
    EXPECT_EQ(header.kind, wire::FrameKind::geometry);
    EXPECT_EQ(header.flags & wire::first_of_frame, wire::first_of_frame);
    while ((header.flags & wire::last_of_frame) == 0) header = client.next_frame();
    client.acknowledge(header);
    client.call("scene.patch", in_session({{"patch", {{"camera", {{"fov", 40}}}}}}));
    client.call("scene.patch", in_session({{"patch", {{"layers", {{"iso", {{"visible", false}}}}}}}}));
    header = client.next_frame();
    EXPECT_EQ(header.revision, 3U) << "none for the camera";
    EXPECT_EQ(header.frame, 2U);
    EXPECT_EQ(client.call("view.stream", {{"view", header.view}, {"stream", "image"}}), nullptr);
    while (header.kind == wire::FrameKind::geometry) header = client.next_frame();
    EXPECT_EQ(header.kind, wire::FrameKind::image);
}

TEST_F(Methods, what_a_frame_lacks_is_told_and_the_rest_is_shown) {
    client.call("view.open", in_session({{"width", 64}, {"height", 64}}));
    const auto whole = client.frames_until_still(1).back().triangles;
    client.call("scene.patch", in_session({{"patch", {{"layers", {{"iso", {{"array", "late"}}}}}}}}));
    const json lacking = client.next_text();
    EXPECT_EQ(lacking["method"], "view.lacking");
    EXPECT_EQ(lacking["params"]["revision"], 2);
    ASSERT_EQ(lacking["params"]["sentences"].size(), 1U);
    EXPECT_THAT(lacking["params"]["sentences"][0].get<std::string>(),
                testing::AllOf(testing::HasSubstr("iso"), testing::HasSubstr("'late' was not written at time 0")));
    const auto rest = client.frames_until_still(2).back().triangles;
    EXPECT_GT(rest, 0U);
    EXPECT_LT(rest, whole);
    const json picture = client.call("picture.render", in_session({{"width", 64}, {"height", 64}}));
    EXPECT_EQ(picture["remarks"], lacking["params"]["sentences"]) << "the picture of the rest, which says the same";
    client.call("scene.patch", in_session({{"patch", {{"time", 2}}}}));
    EXPECT_EQ(client.next_text()["params"]["sentences"], json::array());
    EXPECT_EQ(client.frames_until_still(3).back().time, 2);
}

TEST_F(Methods, what_was_not_written_is_left_out_of_pictures_and_refused_in_files) {
    json params{{"scene", colored_scene}, {"width", 64}, {"height", 64}};
    json& layers = params["scene"]["layers"];
    layers["plane"] = {{"type", "slice"}, {"axis", "x"}, {"value", 1001}, {"color", {{"array", "late"}}}};
    json plain = params;
    plain["scene"]["layers"]["plane"]["color"] = json::object();
    const json grey = client.call("picture.render", params);
    EXPECT_EQ(grey["remarks"],
              json::array({"layer plane has no colours: 'late' was not written at time 0; it was at 2"}));
    EXPECT_EQ(grey["data"], client.call("picture.render", plain)["data"]);
    layers.erase("plane");
    layers["iso"]["array"] = "late";
    const json alone = client.call("picture.render", params);
    EXPECT_EQ(alone["remarks"], json::array({"layer iso is not shown: 'late' was not written at time 0; it was at 2"}));
    plain["scene"]["layers"] = json::object();
    EXPECT_EQ(alone["data"], client.call("picture.render", plain)["data"]);

    EXPECT_NE(client.call("scene.camera", params)["position"], nullptr);
    EXPECT_EQ(client.call("scene.bounds", {{"scene", params["scene"]}})["bounds"].size(), 6U);
    EXPECT_EQ(client.call("color.range", {{"scene", params["scene"]}, {"layers", {"iso"}}})["range"], nullptr);
    params["pixel"] = {32, 32};
    EXPECT_EQ(client.call("probe.point", params)["hit"], false);
    EXPECT_EQ(client.error_code("surface.export", {{"scene", params["scene"]}, {"layer", "iso"}, {"format", "stl"}}),
              -32005);
}

TEST_F(Methods, pictures_of_a_session_and_of_a_scene_in_place) {
    const json of_session = client.call("picture.render", in_session({{"width", 100}, {"height", 80}}));
    EXPECT_EQ(of_session["revision"], 1);
    EXPECT_EQ(decoded(of_session["data"]).substr(1, 3), "PNG");
    Client script(server, false);
    json params{{"scene", colored_scene}, {"width", 100}, {"height", 80}};
    const json picture = script.call("picture.render", params);
    EXPECT_EQ(picture["time"], 0);
    params["scene"]["layers"] = json::object();
    EXPECT_NE(script.call("picture.render", params)["data"], picture["data"]);
    params["scene"]["layers"] = colored_scene["layers"];
    EXPECT_EQ(script.call("picture.render", params)["data"], picture["data"]) << "the same bytes for the same scene";
}

TEST_F(Methods, probe_by_position_and_by_pixel) {
    json params{{"scene", colored_scene}, {"position", {1001, 1, -49}}};
    const json here = client.call("probe.point", params);
    EXPECT_EQ(here["hit"], true);
    EXPECT_NEAR(here["values"]["p"], 6, 1e-4);
    params["position"] = {0, 0, 0};
    EXPECT_EQ(client.call("probe.point", params)["hit"], false);

    // Looks along x through the box's middle at the plane x = 1001.
    params.erase("position");
    params["scene"] = json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47]},
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001}}})");
    params.update({{"width", 101}, {"height", 101}, {"pixel", {50, 50}}});
    const json hit = client.call("probe.point", params);
    ASSERT_EQ(hit["hit"], true);
    const Vec3d at = hit["position"];
    EXPECT_NEAR(at[0], 1001, 0.01);
    EXPECT_NEAR(at[1], 3, 0.1);
    EXPECT_NEAR(hit["values"]["p"].get<double>(), pressure({at[0] - 1000, at[1], at[2] + 50}, 0), 1e-3);
    params["pixel"] = {0, 0};
    const json background = client.call("probe.point", params);
    EXPECT_EQ(background["hit"], false);
    EXPECT_EQ(background["position"], nullptr);
}

TEST_F(Methods, probes_and_picks_name_the_layer_and_the_patch) {
    json params{{"pixel", {50, 50}}, {"width", 101}, {"height", 101}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3.1, -47.3], "target": [1003, 3.1, -47.3]},
        "layers": {"walls": {"type": "surface"}}})")}};
    const json probed = client.call("probe.point", params);
    EXPECT_EQ(probed["layer"], "walls");
    EXPECT_EQ(probed["patch"], "left");
    const json picked = client.call("scene.pick", params);
    EXPECT_EQ(picked["layer"], "walls");
    EXPECT_EQ(picked["patch"], "left");
    EXPECT_NEAR(picked["position"][0].get<double>(), 1000, 1e-3);
    params["scene"]["layers"]["walls"]["groups"] = {"body"};
    EXPECT_EQ(client.call("probe.point", params)["patch"], "body");
    params["pixel"] = {0, 0};
    const json background = client.call("scene.pick", params);
    EXPECT_EQ(background["position"], nullptr);
    EXPECT_EQ(background["layer"], nullptr);
    EXPECT_EQ(background["centre"], json({1003, 3, -47})) << "of the body, though the pixel is beside it";
    EXPECT_EQ(client.call("probe.point", params)["patch"], nullptr);
    params.erase("pixel");
    params["position"] = {1001, 1, -49};
    EXPECT_EQ(client.call("probe.point", params)["layer"], nullptr) << "a position is on no layer";
}

TEST_F(Methods, bounds_of_the_mesh_and_of_what_is_drawn) {
    json params{{"scene", {{"dataset", "box"}, {"layers", {{"b", {{"type", "surface"}, {"groups", {"body"}}}}}}}}};
    EXPECT_EQ(client.call("scene.bounds", params)["bounds"], json({1000, 1006, 0, 6, -50, -44}));
    params["of"] = "drawn";
    EXPECT_EQ(client.call("scene.bounds", params)["bounds"], json({1002, 1004, 2, 4, -48, -46}));
}

TEST_F(Methods, color_range_is_that_of_the_values_in_view) {
    json params{{"layers", {"s"}}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47], "parallel": true, "parallel_height": 100},
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001, "color": {"array": "U:x"}},
                   "plain": {"type": "slice", "axis": "x", "value": 1002}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6})); // U:x is the height over the box's floor
    params["aspect"] = 1;
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    json& camera = params["scene"]["camera"];
    camera["parallel_height"] = 2.5; // heights from 1.75 to 4.25 are in view
    const json part = client.call("color.range", params)["range"];
    EXPECT_GE(part[0], 1.75);
    EXPECT_LE(part[0], 3);
    EXPECT_GE(part[1], 3);
    EXPECT_LE(part[1], 4.25);
    camera["target"] = {1003, 3, 1000};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "nothing is in view";
    params.erase("aspect");
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["layers"] = {"plain"};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "a layer without an array has no values";
    params["layers"] = {"s", "none"};
    EXPECT_EQ(client.error_code("color.range", params), -32001);
}

TEST_F(Methods, a_clip_plane_far_beyond_the_mesh_takes_all_away_or_nothing) {
    json params{{"width", 60}, {"height", 40}, {"scene", json::parse(R"({"dataset": "box",
        "layers": {"s": {"type": "surface"}}})")}};
    const json whole = client.call("picture.render", params)["data"];
    json& clip = params["scene"]["layers"]["c"];
    clip = {{"type", "clip"}, {"origin", {1e300, 3, 0}}, {"normal", {1, 1, 0}}};
    EXPECT_EQ(client.call("picture.render", params)["data"], whole);
    clip["invert"] = true;
    const json nothing = client.call("picture.render", params)["data"];
    EXPECT_NE(nothing, whole);
    params["scene"]["layers"] = json::object();
    EXPECT_EQ(client.call("picture.render", params)["data"], nothing);
}

TEST_F(Methods, a_scene_without_a_camera_is_seen_from_where_its_pictures_are) {
    json params{{"width", 300}, {"height", 200}, {"scene", json::parse(R"({"dataset": "box",
        "annotations": {"axes": true, "title": "A title"},
        "layers": {"s": {"type": "surface", "color": {"array": "p"}}}})")}};
    const json camera = client.call("scene.camera", params);
    const json picture = client.call("picture.render", params);
    json given = params;
    given["scene"]["camera"] = camera;
    EXPECT_EQ(client.call("picture.render", given)["data"], picture["data"]);
    EXPECT_EQ(client.call("scene.camera", given), camera);
    params["scene"]["annotations"]["axes"] = false;
    EXPECT_NE(client.call("scene.camera", params), camera) << "it leaves room for what is written";
    given["scene"]["camera"] = {{"position", {0, 0, 9}}, {"target", {0, 0, 0}}, {"up", {0, 1, 0}}, {"fov", 20},
                                {"parallel", true},      {"parallel_height", 3}};
    EXPECT_EQ(client.call("scene.camera", given), given["scene"]["camera"]);
}

// U:x goes from 0 to 6, p over other values: a range of both would be of neither.
TEST_F(Methods, color_range_of_contour_lines_is_apart_from_that_of_the_slice_below_them) {
    json params{{"layers", {"s"}}, {"scene", json::parse(R"({"dataset": "box",
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001, "color": {"array": "U:x"},
                         "contours": {"array": "p", "values": [11, 14, 1e6], "coloring": {}}}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["of"] = "contours";
    EXPECT_EQ(client.call("color.range", params)["range"], json({11, 14})) << "of the lines that there are";
    params["scene"]["layers"]["s"]["contours"].erase("coloring");
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "lines of one colour are on no scale";
    params["of"] = "edges";
    EXPECT_EQ(client.error_code("color.range", params), -32602);
}

// U:x is the height over the box's floor, at z = -50.
TEST_F(Methods, color_range_of_a_volume_is_that_of_what_is_in_view_and_not_cut_away) {
    json params{{"layers", {"v"}}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47], "parallel": true, "parallel_height": 100},
        "layers": {"v": {"type": "volume", "array": "U:x", "slices": 60}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["aspect"] = 1;
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    json& camera = params["scene"]["camera"];
    camera["parallel_height"] = 2.5; // heights from 1.75 to 4.25
    const json part = client.call("color.range", params)["range"];
    ASSERT_TRUE(part.is_array());
    EXPECT_GE(part[0], 1.75);
    EXPECT_LE(part[0], 2);
    EXPECT_GE(part[1], 4);
    EXPECT_LE(part[1], 4.25);
    camera["parallel_height"] = 100;
    params["scene"]["layers"]["c"] = {{"type", "clip"}, {"axis", "z"}, {"value", -47.5}};
    const json cut = client.call("color.range", params)["range"];
    EXPECT_EQ(cut[0], 0);
    EXPECT_GE(cut[1], 2);
    EXPECT_LE(cut[1], 2.5);
    camera["parallel_height"] = 2.5;
    camera["target"] = {1003, 3, 1000};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "nothing is in view";
}

TEST_F(Methods, surfaces_are_exported) {
    json params{{"scene", colored_scene}, {"layer", "iso"}, {"format", "ply"}};
    params["scene"]["layers"]["iso"]["values"] = {12, 20};
    const json ply = client.call("surface.export", params);
    EXPECT_EQ(ply["name"], "iso.ply");
    const std::string head = decoded(ply["data"]).substr(0, 400);
    EXPECT_THAT(head, testing::HasSubstr("element vertex " + ply["vertices"].dump() + "\n"));
    EXPECT_THAT(head, testing::HasSubstr("element face " + ply["polygons"].dump() + "\n"));
    params["scene"]["layers"]["iso"]["values"] = {12};
    const json one = client.call("surface.export", params);
    params["scene"]["layers"]["iso"]["values"] = {20};
    const json other = client.call("surface.export", params);
    EXPECT_EQ(ply["polygons"], one["polygons"].get<int>() + other["polygons"].get<int>());

    params["format"] = "vtp";
    const json vtp = client.call("surface.export", params);
    EXPECT_EQ(vtp["polygons"], other["polygons"]);
    EXPECT_THAT(decoded(vtp["data"]),
                testing::AllOf(testing::HasSubstr("<Piece NumberOfPoints=\"" + other["vertices"].dump() + "\" "),
                               testing::HasSubstr(" NumberOfPolys=\"" + other["polygons"].dump() + "\">"),
                               testing::EndsWith("</VTKFile>\n")));

    params["format"] = "stl";
    const json stl = client.call("surface.export", params);
    const std::string triangles = decoded(stl["data"]);
    EXPECT_GE(stl["polygons"], other["polygons"]) << "of triangles";
    ASSERT_EQ(triangles.size(), 84 + 50 * stl["polygons"].get<std::size_t>());
    std::uint32_t count = 0;
    std::memcpy(&count, &triangles[80], sizeof count);
    EXPECT_EQ(count, stl["polygons"]);
    params["layer"] = "nope";
    EXPECT_EQ(client.error_code("surface.export", params), -32001);
}

// The box of 6 x 6 x 6 with a hole of 2 x 2 x 2, cut in the middle: its file is closed, and is the half that is seen.
TEST_F(Methods, exports_are_cut_as_pictures_are) {
    json params{{"scene", colored_scene}, {"layer", "s"}, {"format", "stl"}};
    json& layers = params["scene"]["layers"];
    layers = {{"s", {{"type", "surface"}}}, {"c", {{"type", "clip"}, {"axis", "x"}, {"value", box_origin[0] + 3}}}};
    const std::string bytes = decoded(client.call("surface.export", params)["data"]);
    double six = 0;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        std::array<std::array<float, 3>, 3> corner{};
        std::memcpy(&corner, &bytes[at + 12], sizeof corner);
        const auto rel = [&](std::size_t i, std::size_t axis) { return corner[i][axis] - box_origin[axis]; };
        six += rel(0, 0) * (rel(1, 1) * rel(2, 2) - rel(1, 2) * rel(2, 1)) +
               rel(0, 1) * (rel(1, 2) * rel(2, 0) - rel(1, 0) * rel(2, 2)) +
               rel(0, 2) * (rel(1, 0) * rel(2, 1) - rel(1, 1) * rel(2, 0));
    }
    EXPECT_NEAR(six / 6, 3 * 36 - 4, 0.05);
    for (const char* id : {"c", "e"}) {
        layers["e"] = {{"type", "edges"}};
        params["layer"] = id;
        EXPECT_EQ(client.error_code("surface.export", params), -32602) << id;
    }
}

} // namespace
} // namespace ciel::test
