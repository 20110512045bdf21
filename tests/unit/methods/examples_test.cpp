// The contract's examples conform to their schemas, and the server accepts them.
#include "service.hpp"

#include "engine/uploads.hpp"
#include "scene/schema.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

class Examples : public testing::Test {
protected:
    Examples() { client.give_token(); }

    engine::ServerOptions options() {
        write_small_dataset(folder / "box.ciel");
        engine::ServerOptions made;
        made.data = {folder.path()};
        made.extraction = chosen_algorithm();
        made.allow_append = true;
        return made;
    }
    // Replaces session, view and upload ids of an example by ids that this server has issued.
    json with_ids(json params) {
        if (params.contains("session"))
            params["session"] = client.call("session.open", {{"dataset", "box"}})["session"];
        if (params.contains("view")) {
            const json session = client.call("session.open", {{"dataset", "box"}})["session"];
            params["view"] = client.call("view.open", {{"session", session}, {"width", 64}, {"height", 48}})["view"];
        }
        if (params.contains("upload")) params["upload"] = full_upload();
        return params;
    }
    json full_upload() {
        const json begun = client.call(
            "append.begin", {{"dataset", "box"}, {"time", ++time}, {"arrays", json::array({{{"name", "p"}}})}});
        const std::vector<std::uint8_t> values(begun["arrays"][0]["bytes"].get<std::size_t>());
        server.uploads().add({engine::upload_id(begun["upload"]), 0, 0, values});
        return begun["upload"];
    }

    Folder folder;
    double time = 100;
    engine::Server server{options()};
    Client client{server, true};
};

TEST_F(Examples, are_valid_and_the_server_takes_them) {
    for (const json& method : scene::contract().at("methods")) {
        const std::string name = method["name"];
        std::map<std::string, json> schemas;
        for (const json& param : method["params"]) schemas[param["name"]] = param["schema"];
        for (const json& example : method["examples"]) {
            json params = json::object();
            for (const json& param : example["params"]) {
                const auto violation = scene::check_schema(schemas.at(param["name"]), param["value"]);
                EXPECT_FALSE(violation) << name << ": " << param << ": " << violation->reason;
                params[param["name"]] = param["value"];
            }
            const auto violation = scene::check_schema(method["result"]["schema"], example["result"]["value"]);
            EXPECT_FALSE(violation) << name << ": result" << violation->path << ' ' << violation->reason;
            const json answer = client.request(name, with_ids(params));
            ASSERT_TRUE(answer.contains("result")) << name << ": " << answer;
            const auto wrong = scene::check_schema(method["result"]["schema"], answer["result"]);
            EXPECT_FALSE(wrong) << name << ": " << wrong->path << ' ' << wrong->reason;
        }
    }
}

TEST_F(Examples, session_open_declares_the_errors_it_gives) {
    const json& errors = scene::contract()["components"]["errors"];
    std::set<int> declared;
    for (const json& method : scene::contract().at("methods"))
        if (method["name"] == "session.open")
            for (const json& error : method["errors"]) {
                const std::string name = error["$ref"];
                declared.insert(errors[name.substr(name.rfind('/') + 1)]["code"].get<int>());
            }
    const json scene{{"dataset", "box"}, {"layers", {{"a", {{"type", "iso"}, {"array", "nothing"}, {"values", {1}}}}}}};
    std::set<int> given{client.error_code("session.open", {{"dataset", "nothing"}}),
                        client.error_code("session.open", {{"scene", scene}})};
    server.drain();
    given.insert(client.error_code("session.open", {{"dataset", "box"}}));
    EXPECT_EQ(given.count(0), 0U);
    EXPECT_THAT(declared, testing::IsSupersetOf(given));
}

} // namespace
} // namespace ciel::test
