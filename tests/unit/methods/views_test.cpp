// Frames streamed to views, and single pictures on request.
#include "methods.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

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
                testing::AllOf(testing::HasSubstr("iso"), testing::HasSubstr("'late' has no values at time 0")));
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
              json::array({"layer plane has no colors: 'late' has no values at time 0; it has values at 2"}));
    EXPECT_EQ(grey["data"], client.call("picture.render", plain)["data"]);
    layers.erase("plane");
    layers["iso"]["array"] = "late";
    const json alone = client.call("picture.render", params);
    EXPECT_EQ(alone["remarks"],
              json::array({"layer iso is not shown: 'late' has no values at time 0; it has values at 2"}));
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

} // namespace
} // namespace ciel::test
