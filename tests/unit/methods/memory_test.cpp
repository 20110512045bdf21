// Memory that clients can make the server hold, and its accounting in bytes.
#include "service.hpp"

#include "methods/call_context.hpp"
#include "protocol/methods.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <thread>

namespace ciel::test {
using namespace server;
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int invalid_params = -32602, invalid_scene = -32002, limit = -32003;

class Held : public Service {
protected:
    static std::size_t bytes(const engine::Server& server, const std::string& kind) {
        std::istringstream lines(server.metrics());
        const std::string name = "ciel_memory_bytes{kind=\"" + kind + "\"} ";
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(name)) return std::stoull(line.substr(name.size()));
        ADD_FAILURE() << kind << " is not counted";
        return SIZE_MAX;
    }
    static json outline(const std::string& id) { return {{"layers", {{id, {{"type", "outline"}}}}}}; }
    static std::string open(Client& client) { return client.call("session.open", {{"dataset", "box"}})["session"]; }
    static json patch(Client& client, const std::string& session, json change) {
        return client.request("scene.patch", {{"session", session}, {"patch", std::move(change)}});
    }
};

TEST_F(Held, names_have_at_most_256_bytes) {
    engine::Server server(options());
    Client client(server, false);
    const std::string session = open(client);
    const std::string euro = "\xE2\x82\xAC"; // three bytes, one character
    std::string long_name, fitting_name = "x";
    for (int i = 0; i < 86; ++i) long_name += euro;
    for (int i = 0; i < 85; ++i) fitting_name += euro;
    for (const std::string& name : {std::string(257, 'a'), std::string(900'000, 'a'), long_name}) {
        const json answer = patch(client, session, outline(name));
        EXPECT_EQ(answer["error"]["code"], invalid_scene);
        EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("at most 256"));
        EXPECT_LT(answer.dump().size(), 1000U) << "the name is not repeated";
        const json titled = patch(client, session, {{"annotations", {{"title", name}}}});
        EXPECT_EQ(titled["error"]["code"], invalid_scene);
        EXPECT_THAT(titled["error"]["data"]["reason"].get<std::string>(), HasSubstr("at most 256"));
        EXPECT_EQ(
            client.error_code("scene.patch", {{"session", session}, {"patch", json::object()}, {"gesture", name}}),
            invalid_params);
        EXPECT_EQ(client.error_code("session.open", {{"session", name}}), invalid_params);
    }
    for (const std::string& name : {std::string(256, 'a'), fitting_name}) {
        EXPECT_TRUE(patch(client, session, outline(name)).contains("result"));
        EXPECT_TRUE(patch(client, session, {{"annotations", {{"title", name}}}}).contains("result"));
        EXPECT_EQ(client.error_code("scene.patch", {{"session", session}, {"patch", {{"time", 1}}}, {"gesture", name}}),
                  0);
    }
}

TEST_F(Held, a_scene_has_at_most_scene_bytes) {
    limits::Limits limits;
    limits.scene_bytes = 3000;
    engine::Server server(options(limits));
    Client client(server, false);
    const std::string session = open(client);
    std::size_t fitting = 0;
    json answer;
    for (char id = 'a'; id <= 'z'; ++id, ++fitting) {
        answer = patch(client, session, outline(std::string(200, id)));
        if (answer.contains("error")) break;
    }
    EXPECT_EQ(answer["error"]["code"], limit);
    EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("at most 3000"));
    EXPECT_GT(fitting, 5U);
    const json scene = client.call("scene.get", {{"session", session}})["scene"];
    EXPECT_LE(scene.dump().size(), 3000U);
    EXPECT_TRUE(patch(client, session, {{"layers", {{std::string(200, 'a'), nullptr}}}}).contains("result"));
    json large = scene;
    for (char id = 'A'; id <= 'Z'; ++id) large["layers"][std::string(200, id)] = {{"type", "outline"}};
    EXPECT_EQ(client.error_code("session.open", {{"scene", large}}), limit);
    EXPECT_EQ(client.error_code("picture.render", {{"scene", large}, {"width", 16}, {"height", 16}}), limit);
}

TEST_F(Held, a_history_has_at_most_history_bytes) {
    limits::Limits limits;
    limits.history_bytes = 100'000;
    engine::Server server(options(limits));
    Client client(server, true);
    const std::string session = open(client);
    for (char id = 'a'; id <= 't'; ++id)
        ASSERT_TRUE(patch(client, session, outline(std::string(256, id))).contains("result"));
    for (int i = 1; i <= 200; ++i) {
        ASSERT_TRUE(patch(client, session, {{"time", 0.001 * i}}).contains("result"));
        ASSERT_LE(bytes(server, "scenes"), 160'000U) << "after " << i; // the scene itself takes 30 kB
    }
    EXPECT_EQ(client.call("scene.undo", {{"session", session}})["scene"]["time"], 0.199);
    client.call("session.close", {{"session", session}});
    EXPECT_EQ(bytes(server, "scenes"), 0U);
}

json whole_export(int id) {
    return {{"jsonrpc", "2.0"},
            {"id", id},
            {"method", "surface.export"},
            {"params",
             {{"scene", {{"dataset", "box"}, {"layers", {{"s", {{"type", "surface"}}}}}}},
              {"layer", "s"},
              {"format", "ply"}}}};
}

TEST_F(Held, the_answers_of_a_batch_have_at_most_batch_answer_bytes) {
    engine::Server unlimited(options());
    const std::size_t of_one = Client(unlimited, false).post(whole_export(0)).get().size();
    limits::Limits limits;
    limits.batch_answer_bytes = 3 * of_one + of_one / 2;
    engine::Server server(options(limits));
    Client client(server, false);
    json batch = json::array();
    for (int id = 0; id < 16; ++id) batch.push_back(whole_export(id));
    batch.push_back({{"jsonrpc", "2.0"}, {"id", "last"}, {"method", "dataset.list"}});
    const std::string text = client.post(batch).get();
    const json answers = json::parse(text);
    ASSERT_EQ(answers.size(), 17U);
    std::size_t made = 0;
    for (int id = 0; id < 16; ++id) {
        EXPECT_EQ(answers[id]["id"], id);
        if (answers[id].contains("result")) {
            ++made;
            continue;
        }
        EXPECT_EQ(answers[id]["error"]["code"], limit);
        EXPECT_THAT(answers[id]["error"]["data"]["reason"].get<std::string>(), HasSubstr("send this request alone"));
    }
    EXPECT_EQ(made, 3U);
    EXPECT_TRUE(answers[16].contains("result")) << "a small answer still fits";
    EXPECT_LE(text.size(), limits.batch_answer_bytes + 1000 * 17);
    EXPECT_EQ(bytes(server, "answers"), 0U);
    EXPECT_THAT(server.metrics(), HasSubstr("ciel_rpc_errors_total{code=\"-32003\"} 13\n"));
    EXPECT_THAT(client.post(whole_export(1)).get(), HasSubstr("\"result\"")) << "by itself";
}

TEST_F(Held, the_total_is_kept_and_said) {
    const json scene = json::parse(R"({"dataset": "box", "layers": {"iso": {
        "type": "iso", "array": "p", "values": [8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28]}}})");
    const auto draw = [&](Client& client) {
        const json session = client.call("session.open", {{"scene", scene}})["session"];
        return std::pair(session,
                         client.request("picture.render", {{"session", session}, {"width", 16}, {"height", 16}}));
    };
    limits::Limits limits;
    {
        engine::Server measured(options());
        Client measuring(measured, false);
        ASSERT_TRUE(draw(measuring).second.contains("result"));
        ASSERT_GT(bytes(measured, "scenes"), 0U);
        ASSERT_GT(bytes(measured, "surfaces"), 10 * bytes(measured, "scenes"));
        limits.memory_bytes =
            bytes(measured, "datasets") + bytes(measured, "drawing") + 5 * bytes(measured, "surfaces") / 2;
    }
    engine::Server server(options(limits));
    Client client(server, true);
    const auto first = draw(client), second = draw(client), third = draw(client); // each session keeps its surfaces
    EXPECT_TRUE(first.second.contains("result"));
    EXPECT_TRUE(second.second.contains("result"));
    ASSERT_TRUE(third.second.contains("error"));
    EXPECT_EQ(third.second["error"]["code"], limit);
    EXPECT_THAT(third.second["error"]["data"]["reason"].get<std::string>(), HasSubstr("the server may hold"));
    EXPECT_LE(bytes(server, "scenes") + bytes(server, "surfaces") + bytes(server, "datasets") +
                  bytes(server, "drawing"),
              limits.memory_bytes);
    EXPECT_THAT(server.metrics(), HasSubstr("ciel_memory_limit_bytes " + std::to_string(limits.memory_bytes) + "\n"));
    client.call("session.close", {{"session", first.first}});
    EXPECT_TRUE(draw(client).second.contains("result")) << "what is closed makes room";

    engine::Server by_post(options(limits));
    Client script(by_post, false);
    for (int i = 0; i < 6; ++i)
        EXPECT_TRUE(draw(script).second.contains("result")) << "sessions without a connection make room: " << i;
    EXPECT_GT(bytes(by_post, "scenes"), 5 * bytes(server, "scenes") / 4) << "the sessions themselves stay";
}

TEST_F(Held, the_buffers_of_a_picture_are_counted_and_refused) {
    const json picture = {{"scene", scene_with_iso()}, {"width", 512}, {"height", 512}};
    limits::Limits limits;
    {
        engine::Server measured(options());
        Client measuring(measured, false);
        EXPECT_EQ(bytes(measured, "drawing"), 0U);
        measuring.call("picture.render", picture);
        EXPECT_GT(bytes(measured, "drawing"), std::size_t{512} * 512 * 8);
        limits.memory_bytes = bytes(measured, "datasets") + bytes(measured, "drawing") / 2;
    }
    engine::Server server(options(limits));
    Client client(server, false);
    const json answer = client.request("picture.render", picture);
    ASSERT_TRUE(answer.contains("error"));
    EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("left of what the server may use"));
}

TEST_F(Held, parsed_requests_are_counted_before_they_wait) {
    std::string lists = "[]";
    while (lists.size() < 300'000) lists += ",[]";
    const std::string text = R"({"jsonrpc": "2.0", "id": 1, "method": "picture.render", "params": {"scene": [)" +
                             lists + R"(], "width": 16, "height": 16}})";
    limits::Limits limits;
    limits.memory_bytes = 1 << 20;
    engine::Server server(options(limits));
    Client client(server, false);
    const json answer = json::parse(client.send(text));
    EXPECT_EQ(answer["id"], 1);
    EXPECT_EQ(answer["error"]["code"], limit);
    EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("the server may hold"));
    EXPECT_EQ(bytes(server, "requests"), 0U);
    const json answers = json::parse(client.send("[" + text + R"(, {"jsonrpc": "2.0", "id": "b", "method": "x"}])"));
    ASSERT_EQ(answers.size(), 2U) << "a batch is answered by a batch";
    EXPECT_EQ(answers[0]["id"], 1);
    EXPECT_EQ(answers[1]["id"], "b");
    EXPECT_EQ(answers[1]["error"]["code"], limit);
    EXPECT_EQ(client.send(std::string(text).replace(text.find(R"("id": 1, )"), 9, "")), "") << "a notification";

    engine::Server roomy(options());
    Client other(roomy, false);
    EXPECT_EQ(json::parse(other.send(text))["error"]["code"], invalid_params);
}

// So that clients can close sessions to make room.
TEST_F(Held, short_calls_pass_when_the_memory_is_full) {
    limits::Limits limits;
    limits.memory_bytes = 1;
    engine::Server server(options(limits));
    Client client(server, false);
    EXPECT_TRUE(client.request("server.info").contains("result"));
    EXPECT_EQ(client.error_code("session.close", {{"session", "none"}}), -32001) << "it was looked for";
}

TEST_F(Held, a_refused_call_is_counted_once) {
    limits::Limits limits;
    limits.batch_answer_bytes = 100;
    engine::Server server(options(limits));
    Client client(server, false);
    std::string batch;
    for (int id = 0; id < 5; ++id)
        batch += std::string(id == 0 ? "[" : ", ") + R"({"jsonrpc": "2.0", "id": )" + std::to_string(id) +
                 R"(, "method": "none"})";
    EXPECT_EQ(json::parse(client.send(batch + "]")).size(), 5U);
    EXPECT_THAT(server.metrics(), HasSubstr("ciel_rpc_errors_total{code=\"-32601\"} 5\n"));
    EXPECT_THAT(server.metrics(), Not(HasSubstr("code=\"-32003\"")));
}

TEST_F(Held, cached_fields_are_freed_when_the_memory_is_full) {
    engine::Server server(options());
    Client client(server, false);
    const auto held = server.catalog().open("box"); // the dataset stays
    for (const double time : {0, 1, 2}) {
        json scene = scene_with_iso();
        scene["time"] = time;
        client.call("picture.render", {{"scene", scene}, {"width", 16}, {"height", 16}});
    }
    const std::size_t before = bytes(server, "datasets");
    limits::Memory::Charge all(server.memory(), limits::Held::uploads);
    EXPECT_THROW(all.change(server.memory().most()), limits::LimitReached);
    EXPECT_LT(bytes(server, "datasets"), before);
    EXPECT_GT(bytes(server, "datasets"), 0U);
}

TEST_F(Held, the_result_of_a_call_is_counted_until_its_text_is) {
    engine::Server server(options());
    sessions::Connection connection;
    methods::CallContext context{server, connection};
    protocol::PictureRenderParams params;
    params.scene = scene_with_iso();
    params.width = params.height = 64;
    const auto picture = methods::picture_render(context, params);
    EXPECT_GE(bytes(server, "answers"), 2 * picture.data.size()) << "the result, and the text made of it";
}

// A connection that takes up to `most` bytes of frames and delivers nothing until it is read.
class Unread {
public:
    Unread(engine::Server& server, std::size_t most) : server_(server), most_(most) {
        connection_->id = 1'000'000;
        connection_->send_text = [](const std::string&) {};
        connection_->send_binary = [this](const std::shared_ptr<const std::vector<std::uint8_t>>& bytes) {
            const std::scoped_lock lock(mutex_);
            bytes_ += bytes->size();
            views_.insert(wire::read_frame_header(*bytes).view);
            largest_ = std::max(largest_, bytes_);
        };
        connection_->has_room = [this](std::size_t more) {
            const std::scoped_lock lock(mutex_);
            const bool fits = bytes_ == 0 || bytes_ + more <= most_;
            refused_ = refused_ || !fits;
            return fits;
        };
        server_.connection_opened(connection_);
    }
    ~Unread() { server_.connection_closed(connection_->id); }
    Unread(const Unread&) = delete;

    json call(const std::string& method, const json& params) {
        return json::parse(
            methods::dispatch(server_, *connection_, Client::request_of(method, params).dump()))["result"];
    }
    void read_all() {
        {
            const std::scoped_lock lock(mutex_);
            bytes_ = 0;
        }
        server_.sessions().connection_has_room(connection_->id);
    }
    [[nodiscard]] std::size_t largest() const { return locked(largest_); }
    [[nodiscard]] std::size_t views() const { return locked(views_).size(); }
    [[nodiscard]] bool was_refused() const { return locked(refused_); }

private:
    template <class T>
    T locked(const T& value) const {
        const std::scoped_lock lock(mutex_);
        return value;
    }

    engine::Server& server_;
    std::size_t most_;
    std::shared_ptr<sessions::Connection> connection_ = std::make_shared<sessions::Connection>();
    mutable std::mutex mutex_;
    std::size_t bytes_ = 0, largest_ = 0;
    std::set<std::uint32_t> views_;
    bool refused_ = false;
};

TEST_F(Held, views_that_nobody_reads_take_turns_in_the_room_of_their_connection) {
    engine::Server server(options());
    std::size_t of_one = 0;
    const json scene = json::parse(R"({"dataset": "box", "layers": {"s": {"type": "surface"}}})");
    {
        Client client(server, true);
        const std::string session = client.call("session.open", {{"scene", scene}})["session"];
        client.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}, {"stream", "geometry"}});
        of_one = client.next_message()->size();
    }
    Unread unread(server, 5 * of_one / 2);
    const std::string session = unread.call("session.open", {{"scene", scene}})["session"];
    for (int i = 0; i < 8; ++i)
        unread.call("view.open", {{"session", session}, {"width", 64}, {"height", 64}, {"stream", "geometry"}});
    const auto wait = [&](auto holds) {
        for (int tries = 0; !holds() && tries < 6000; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return holds();
    };
    ASSERT_TRUE(wait([&] { return unread.views() == 2 && unread.was_refused(); }));
    for (std::size_t shown = 4; shown <= 8; shown += 2) {
        unread.read_all();
        ASSERT_TRUE(wait([&] { return unread.views() == shown; })) << shown;
    }
    EXPECT_LE(unread.largest(), 5 * of_one / 2);
}

} // namespace
} // namespace ciel::test
