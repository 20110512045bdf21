// Requests that declare the contract version of their client.
#include "protocol/document.hpp"
#include "service.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

using protocol::major_version, protocol::minor_version;

class ProtocolVersion : public Service {
protected:
    json ask(const json& declared, const std::string& method, json params) {
        json request = Client::request_of(method, std::move(params));
        request["protocol"] = declared;
        return json::parse(client.send(request.dump()));
    }
    static json version(int major, int minor) { return {{"major", major}, {"minor", minor}}; }
    static json later() { return version(major_version, minor_version + 1); }
    static json scene() {
        json scene = scene_with_iso();
        scene["layers"]["iso"]["glow"] = 2;
        scene["fog"] = {{"density", 1}};
        return scene;
    }

    engine::Server server{options()};
    Client client{server, false};
};

TEST_F(ProtocolVersion, unknown_members_of_a_later_minor_are_ignored_and_named) {
    const json answer = ask(later(), "session.open", {{"scene", scene()}, {"mood", "calm"}});
    EXPECT_EQ(answer["result"]["scene"], scene_with_iso());
    EXPECT_EQ(answer["ignored"], json({"/mood", "/scene/fog", "/scene/layers/iso/glow"}));
}

TEST_F(ProtocolVersion, so_are_those_of_a_patch) {
    const std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    const json patch = json::parse(R"({"fog": null, "camera": {"roll": 1, "fov": 40}, "layers": {
        "iso": {"color": {"map": "grayscale", "shine": 1}, "edges": {"dash": 3}},
        "new": {"type": "slice", "axis": "x", "value": 1003, "groups": ["body"]}}})");
    const json answer = ask(later(), "scene.patch", {{"session", session}, {"patch", patch}});
    EXPECT_EQ(answer["ignored"], json({"/patch/camera/roll", "/patch/fog", "/patch/layers/iso/color/shine",
                                       "/patch/layers/iso/edges/dash", "/patch/layers/new/groups"}));
    const json scene = client.call("scene.get", {{"session", session}})["scene"];
    EXPECT_EQ(scene["camera"]["fov"], 40);
    EXPECT_EQ(scene["layers"]["iso"]["color"], json({{"map", "grayscale"}}));
    EXPECT_EQ(scene["layers"]["iso"]["edges"], json::object());
    EXPECT_FALSE(scene["layers"]["new"].contains("groups"));
}

TEST_F(ProtocolVersion, and_those_of_the_steps_to_undo) {
    const json steps = json::array({{{"fog", nullptr}, {"layers", {{"iso", {{"glow", 1}, {"opacity", 0.5}}}}}}});
    const json answer = ask(later(), "session.open", {{"scene", scene_with_iso()}, {"undo", steps}});
    EXPECT_EQ(answer["ignored"], json({"/undo/0/fog", "/undo/0/layers/iso/glow"}));
    const std::string session = answer["result"]["session"];
    EXPECT_EQ(client.call("scene.undo", {{"session", session}})["scene"]["layers"]["iso"]["opacity"], 0.5);
}

TEST_F(ProtocolVersion, everybody_else_has_them_refused) {
    for (const json& declared : {version(major_version, minor_version), version(major_version, 0)}) {
        const json answer = ask(declared, "session.open", {{"scene", scene()}});
        EXPECT_EQ(answer["error"]["data"]["path"], "/scene/layers/iso/glow") << declared;
        EXPECT_FALSE(answer.contains("ignored"));
    }
    EXPECT_EQ(client.error_code("session.open", {{"scene", scene()}}), -32602);
}

TEST_F(ProtocolVersion, a_later_minor_may_not_break_the_rules_of_known_members) {
    json wrong = scene();
    wrong["layers"]["iso"]["opacity"] = 3;
    EXPECT_EQ(ask(later(), "session.open", {{"scene", wrong}})["error"]["data"]["path"], "/scene/layers/iso/opacity");
    json of_new_type = scene();
    of_new_type["layers"]["iso"]["type"] = "streamlines";
    EXPECT_EQ(ask(later(), "session.open", {{"scene", of_new_type}})["error"]["data"]["path"],
              "/scene/layers/iso/type");
}

TEST_F(ProtocolVersion, nothing_is_named_where_nothing_was_ignored) {
    EXPECT_FALSE(ask(later(), "dataset.list", json::object()).contains("ignored"));
}

TEST_F(ProtocolVersion, another_major_is_refused_in_words) {
    const json answer = ask(version(major_version + 1, 0), "dataset.list", json::object());
    EXPECT_EQ(answer["error"]["code"], -32600);
    EXPECT_EQ(answer["error"]["data"]["reason"],
              "the request is of protocol version 2.0; this server has version 1.1; use a client of major version 1");
}

TEST_F(ProtocolVersion, a_malformed_declaration_is_refused) {
    for (const char* declared :
         {"1", "null", "[1, 1]", R"("1.1")", "{}", R"({"major": 1})", R"({"major": 1, "minor": -1})",
          R"({"major": 1.5, "minor": 1})", R"({"major": "1", "minor": 1})"}) {
        const json answer = ask(json::parse(declared), "dataset.list", json::object());
        EXPECT_EQ(answer["error"]["data"]["reason"], R"(protocol must be of the form {"major": 1, "minor": 0})")
            << declared;
    }
}

} // namespace
} // namespace ciel::test
