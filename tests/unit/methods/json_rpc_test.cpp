// JSON-RPC 2.0: the examples of the specification, and a table of malformed messages.
#include "service.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

class JsonRpc : public Service {
protected:
    engine::Server server{options()};
    Client client{server, false};
};

// Removes `data` from errors, whose content the specification leaves to the server.
json without_data(json answer) {
    for (json* one : answer.is_array() ? [&] {
             std::vector<json*> all;
             for (json& element : answer) all.push_back(&element);
             return all;
         }()
                                       : std::vector<json*>{&answer})
        if (one->contains("error")) (*one)["error"].erase("data");
    return answer;
}

struct Row {
    const char *name, *text, *answer; // an empty answer means that nothing is sent back
};

constexpr Row table[] = {
    // https://www.jsonrpc.org/specification, section 7, without the examples that need a method "subtract".
    {"non-existent method", R"({"jsonrpc": "2.0", "method": "foobar", "id": "1"})",
     R"({"jsonrpc": "2.0", "error": {"code": -32601, "message": "Method not found"}, "id": "1"})"},
    {"invalid JSON", R"({"jsonrpc": "2.0", "method": "foobar, "params": "bar", "baz])",
     R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"invalid Request object", R"({"jsonrpc": "2.0", "method": 1, "params": "bar"})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null})"},
    {"batch, invalid JSON",
     R"([{"jsonrpc": "2.0", "method": "sum", "params": [1,2,4], "id": "1"}, {"jsonrpc": "2.0", "method"])",
     R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"empty array", R"([])",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null})"},
    {"invalid batch, not empty", R"([1])",
     R"([{"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null}])"},
    {"invalid batch", R"([1,2,3])",
     R"([{"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null},
         {"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null},
         {"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null}])"},
    {"batch",
     R"([{"jsonrpc": "2.0", "method": "dataset.list", "id": "1"}, {"jsonrpc": "2.0", "method": "notify_hello", "params": [7]},
         {"jsonrpc": "2.0", "method": "dataset.list", "params": [], "id": 2}, {"foo": "boo"},
         {"jsonrpc": "2.0", "method": "foo.get", "params": {"name": "myself"}, "id": "5"}])",
     R"([{"jsonrpc": "2.0", "result": [{"name": "bax", "problem": ""}, {"name": "box", "problem": ""}], "id": "1"},
         {"jsonrpc": "2.0", "result": [{"name": "bax", "problem": ""}, {"name": "box", "problem": ""}], "id": 2},
         {"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null},
         {"jsonrpc": "2.0", "error": {"code": -32601, "message": "Method not found"}, "id": "5"}])"},
    {"batch of notifications",
     R"([{"jsonrpc": "2.0", "method": "notify_sum", "params": [1,2,4]}, {"jsonrpc": "2.0", "method": "dataset.list"}])",
     ""},
    // Cases that are not in the specification.
    {"a notification is not answered", R"({"jsonrpc": "2.0", "method": "dataset.list"})", ""},
    {"nor one that fails", R"({"jsonrpc": "2.0", "method": "dataset.describe", "params": {"dataset": 7}})", ""},
    {"id null is a request", R"({"jsonrpc": "2.0", "method": "foo", "id": null})",
     R"({"jsonrpc": "2.0", "error": {"code": -32601, "message": "Method not found"}, "id": null})"},
    {"nothing", "", R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"two values", "{} {}", R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"a number too large", R"({"jsonrpc": "2.0", "method": "dataset.list", "params": [1e999], "id": 1})",
     R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"not UTF-8", "\"\xff\"", R"({"jsonrpc": "2.0", "error": {"code": -32700, "message": "Parse error"}, "id": null})"},
    {"a text", R"("dataset.list")",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null})"},
    {"a member twice", R"({"jsonrpc": "2.0", "method": "dataset.list", "method": "dataset.open", "id": 1})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null})"},
    {"version 1", R"({"method": "dataset.list", "params": [], "id": 1})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": 1})"},
    {"version as a number", R"({"jsonrpc": 2.0, "method": "dataset.list", "id": 1})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": 1})"},
    {"params are a text", R"({"jsonrpc": "2.0", "method": "dataset.list", "params": "x", "id": 1})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": 1})"},
    {"an id that is an object", R"({"jsonrpc": "2.0", "method": "dataset.list", "id": {}})",
     R"({"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null})"},
    {"the largest ids", R"([{"jsonrpc": "2.0", "method": "foo", "id": 18446744073709551615},
                           {"jsonrpc": "2.0", "method": "foo", "id": -9223372036854775808}])",
     R"([{"jsonrpc": "2.0", "error": {"code": -32601, "message": "Method not found"}, "id": 18446744073709551615},
         {"jsonrpc": "2.0", "error": {"code": -32601, "message": "Method not found"}, "id": -9223372036854775808}])"},
    {"a batch in a batch", R"([[]])",
     R"([{"jsonrpc": "2.0", "error": {"code": -32600, "message": "Invalid Request"}, "id": null}])"},
};

TEST_F(JsonRpc, table_of_messages) {
    for (const Row& row : table) {
        const std::string answer = client.send(row.text);
        if (*row.answer == '\0')
            EXPECT_EQ(answer, "") << row.name;
        else
            EXPECT_EQ(without_data(json::parse(answer)), json::parse(row.answer)) << row.name;
    }
}

TEST_F(JsonRpc, an_id_comes_back_with_the_characters_it_came_with) {
    const auto answer = [&](const std::string& request) { return client.send(request); };
    const std::string nines(3000, '9');
    for (const std::string id : {"1.5",
                                 "1e2",
                                 "1E+2",
                                 "1.50",
                                 "0.10",
                                 "-0",
                                 "-0.0",
                                 "0",
                                 "-1",
                                 "18446744073709551615",
                                 "18446744073709551616",
                                 "-9223372036854775809",
                                 "123456789012345678901234567890",
                                 "1.00000000000000000001",
                                 "1e-400",
                                 "1E400",
                                 "-1e309",
                                 nines.c_str(),
                                 "\"1.5\"",
                                 "null"}) {
        const std::string head = R"({"jsonrpc": "2.0", "method": ")";
        const std::string failed = answer(head + R"(foo", "params": {"id": 7, "x": [{"id": 8}]}, "id": )" + id + "}");
        EXPECT_THAT(failed, testing::HasSubstr("\"id\":" + id + ",")) << id;
        EXPECT_THAT(failed, testing::HasSubstr("-32601")) << id;
        const std::string listed = answer(R"({"id": )" + id + R"(, "method": "dataset.list", "jsonrpc": "2.0"})");
        EXPECT_THAT(listed, testing::HasSubstr("\"id\":" + id + ",")) << id;
        EXPECT_THAT(listed, testing::HasSubstr("\"result\":")) << id;
        if (json::accept(id)) {
            EXPECT_TRUE(json::parse(listed).contains("result")) << id;
        }
    }
    const std::string batch = answer(
        R"([{"jsonrpc": "2.0", "method": "foo", "id": 1.50}, 7, [{"id": 2.50}], {"jsonrpc": "2.0", "method": "dataset.list"},
            {"jsonrpc": "2.0", "method": "dataset.list", "id": 3}, {"jsonrpc": "2.0", "method": "foo", "id": "a"},
            {"jsonrpc": "2.0", "\u0069d": 1e2, "method": "foo"}])");
    const json parsed = json::parse(batch);
    ASSERT_EQ(parsed.size(), 6U) << batch;
    std::vector<std::string> order;
    for (std::size_t at = batch.find("\"id\":"); at != std::string::npos; at = batch.find("\"id\":", at + 1))
        order.push_back(batch.substr(at + 5, batch.find_first_of(",}", at) - at - 5));
    EXPECT_THAT(order, testing::ElementsAre("1.50", "null", "null", "3", "\"a\"", "1e2"));
}

TEST_F(JsonRpc, ids_beyond_a_double_come_back_in_a_batch_too) {
    const std::string batch = client.send(R"([{"id": 1e400, "jsonrpc": "2.0", "method": "foo"},
        {"jsonrpc": "2.0", "method": "foo", "id": 2}, {"jsonrpc": "2.0", "method": "foo", "id":-2E999 }])");
    std::vector<std::string> order;
    for (std::size_t at = batch.find("\"id\":"); at != std::string::npos; at = batch.find("\"id\":", at + 1))
        order.push_back(batch.substr(at + 5, batch.find_first_of(",}", at) - at - 5));
    EXPECT_THAT(order, testing::ElementsAre("1e400", "2", "-2E999"));
}

TEST_F(JsonRpc, a_number_too_large_is_called_that) {
    const json answer = json::parse(client.send(R"({"jsonrpc": "2.0", "method": "foo", "params": [1e400], "id": 1})"));
    EXPECT_EQ(answer["error"]["data"]["reason"], "a number in the message is too large; the largest is about 1.8e308");
    for (const char* text : {R"({"jsonrpc": "2.0", "method": "foo", "params": [1e400], "id": 1e400})",
                             R"({"jsonrpc": "2.0", "method": "foo", "params": {"id": 1e400}, "id": 1})", "1e400",
                             R"([{"id": 1e400, "id": 1e401}, 1e400])"})
        EXPECT_THAT(client.send(text), testing::HasSubstr("a number in the message is too large")) << text;
}

TEST_F(JsonRpc, a_member_that_stands_twice_is_named) {
    const json answer = json::parse(client.send(R"({"jsonrpc": "2.0", "method": "scene.patch", "id": 1, "params": {
        "session": "s", "patch": {"layers": {"a": {"opacity": 1}, "b": {"opacity": 1}, "a": null}}}})"));
    EXPECT_EQ(answer["error"]["data"]["reason"],
              "\"a\" occurs twice in the same object; remove one of the two members");
}

// A parser that searched the list at the end of each object took time n^2: 16 s for this text.
TEST_F(JsonRpc, a_long_list_of_objects_is_read) {
    std::string objects = "{}";
    while (objects.size() < 1'000'000) objects += ",{}";
    const json answer = json::parse(
        client.send(R"({"jsonrpc": "2.0", "id": 1, "method": "server.info", "params": {"a": [)" + objects + "]}}"));
    EXPECT_EQ(answer["error"]["code"], -32602);
}

struct Params {
    const char *name, *method, *params, *path, *reason;
};
constexpr Params bad_params[] = {
    {"missing", "dataset.describe", R"({})", "/dataset", "/dataset is missing"},
    {"missing by position", "dataset.describe", R"([])", "/dataset", "/dataset is missing"},
    {"too many", "dataset.describe", R"(["box", 1])", "/1", "the call has 2 params; the method takes at most 1"},
    {"unknown", "dataset.list", R"({"x": 1})", "/x", "/x is not a known member"},
    {"type", "dataset.describe", R"({"dataset": 1})", "/dataset", "/dataset must be a string"},
    {"type by position", "dataset.describe", R"([null])", "/dataset", "/dataset must be a string"},
    {"pattern", "scene.get", R"({"session": "../etc"})", "/session",
     "/session must be 1 to 64 of the characters A-Z, a-z, 0-9, _ and -"},
    {"range", "view.open", R"({"session": "s", "width": 15, "height": 100})", "/width", "/width must be at least 16"},
    {"whole number", "view.open", R"({"session": "s", "width": 20.5, "height": 100})", "/width",
     "/width must be a whole number from 16 to 8192"},
    {"enum", "view.stream", R"({"view": 1, "stream": "video"})", "/stream",
     "/stream must be one of \"image\", \"geometry\""},
    {"deep", "picture.render",
     R"({"scene": {"dataset": "box", "layers": {"a": {"type": "iso", "array": "p", "values": "5"}}}})",
     "/scene/layers/a/values", "/scene/layers/a/values must be an array"},
    {"either or", "picture.render", R"({})", "/session", "give a session or a scene"},
    {"point or pixel", "probe.point", R"({"session": "s"})", "/position", "give either a position or a pixel"},
};

TEST_F(JsonRpc, bad_params_are_named) {
    for (const Params& row : bad_params) {
        const json answer = client.request(row.method, json::parse(row.params));
        ASSERT_TRUE(answer.contains("error")) << row.name;
        EXPECT_EQ(answer["error"]["code"], -32602) << row.name;
        EXPECT_EQ(answer["error"]["message"], "Invalid params") << row.name;
        EXPECT_EQ(answer["error"]["data"]["path"], row.path) << row.name;
        EXPECT_EQ(answer["error"]["data"]["reason"], row.reason) << row.name;
    }
}

TEST_F(JsonRpc, params_by_position_are_those_by_name) {
    EXPECT_EQ(client.call("dataset.describe", json::array({"box"})),
              client.call("dataset.describe", {{"dataset", "box"}}));
    EXPECT_EQ(client.call("dataset.histogram", json::array({"box", "p", 1, 16})),
              client.call("dataset.histogram", {{"dataset", "box"}, {"array", "p"}, {"time", 1}, {"bins", 16}}));
}

TEST_F(JsonRpc, message_size_depth_and_batch_have_limits) {
    const limits::Limits limits;
    const auto code = [&](const std::string& text) {
        return json::parse(client.send(text))["error"]["code"].get<int>();
    };
    EXPECT_EQ(code(std::string(limits.message_bytes + 1, ' ')), -32003);
    EXPECT_EQ(code(std::string(limits.message_bytes, ' ')), -32700);
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_EQ(code(nested(limits.json_depth + 1)), -32003);
    EXPECT_EQ(code(nested(500'000)), -32003);
    EXPECT_NE(client.send(nested(limits.json_depth)).find("-32600"), std::string::npos);
    const std::string brackets =
        R"({"jsonrpc":"2.0","id":1,"method":")" + std::string(100, '[') + "\\\"" + std::string(100, '{') + "\"}";
    EXPECT_EQ(code(brackets), -32601) << "brackets in a text are not depth";
    json batch = json::array();
    for (std::size_t i = 0; i < limits.batch_requests; ++i)
        batch.push_back({{"jsonrpc", "2.0"}, {"id", i}, {"method", "dataset.list"}});
    EXPECT_EQ(json::parse(client.send(batch.dump())).size(), limits.batch_requests);
    batch.push_back(batch[0]);
    EXPECT_EQ(code(batch.dump()), -32003);
}

TEST_F(JsonRpc, requests_and_errors_are_counted) {
    client.call("dataset.list");
    client.request("nonsense");
    const std::string text = server.metrics();
    EXPECT_THAT(text, testing::HasSubstr("ciel_rpc_requests_total{method=\"dataset.list\"} 1\n"));
    EXPECT_THAT(text, testing::HasSubstr("ciel_rpc_requests_total{method=\"unknown\"} 1\n"));
    EXPECT_THAT(text, testing::HasSubstr("ciel_rpc_errors_total{code=\"-32601\"} 1\n"));
}

} // namespace
} // namespace ciel::test
