// Calls that wait for a step which is read from its source.
#include "service.hpp"
#include "store/dataset.hpp"
#include "store/late_writer.hpp"
#include "support/store_box/box.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
namespace {

using testing::HasSubstr;

// A server with the dataset "late". Its step 1 is late.
class LateStep : public testing::Test {
protected:
    LateStep() {
        const store::ArrayInfo p{"p", store::Association::point, 1, "Pa", ""};
        store::Writer writer(folder / "late.ciel", {"late.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(box(2, 2, 2), identity(27), identity(8), {});
        const auto values = values_of(27, 0);
        writer.add_step(0, 0, 0, std::vector<store::ArrayValues>{{p, values}});
        writer.add_late_step(1, 0, 0, std::vector<store::ArrayInfo>{p});
        writer.set_late({{"/data/late.vtu"}, {}, 1, {"", "xxh3:1"}, "a mesh"});
        writer.finish();
    }
    [[nodiscard]] engine::ServerOptions options(engine::ReadLateStep read) const {
        engine::ServerOptions made;
        made.data = {folder.path()};
        made.limits.late_step_seconds = 1;
        made.read_late_step = std::move(read);
        return made;
    }
    // Asks for the box of a surface of step 1.
    static json answer_of(engine::Server& server) {
        Client client(server, false);
        const json scene = {
            {"dataset", "late"}, {"time", 1}, {"layers", {{"a", {{"type", "iso"}, {"array", "p"}, {"values", {5}}}}}}};
        return json::parse(client.post(Client::request_of("scene.bounds", {{"scene", scene}, {"of", "drawn"}})).get());
    }

    const Folder folder;
};

TEST_F(LateStep, a_call_waits_for_it_no_longer_than_the_limit) {
    engine::Server server(options([](const auto&, std::size_t, const std::atomic<bool>& cancel) {
        while (!cancel) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return std::string("cancelled");
    }));
    const auto begun = std::chrono::steady_clock::now();
    const json answer = answer_of(server);
    ASSERT_TRUE(answer.contains("error")) << answer;
    EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("being read"));
    EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::seconds(1));
}

TEST_F(LateStep, a_call_that_waits_is_answered_once_it_is_read) {
    engine::Server server(options([](const store::Dataset& dataset, std::size_t step, const std::atomic<bool>&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        store::LateWriter writer(store::Dataset::open(dataset.directory()), {}, [] {});
        const auto values = values_of(27, step);
        writer.put(step, {{"p", store::Association::point, 1, "Pa", ""}, values});
        writer.end_step(step);
        return std::string();
    }));
    const json answer = answer_of(server);
    EXPECT_TRUE(answer.contains("result")) << answer;
}

TEST_F(LateStep, a_caller_is_told_that_it_is_being_read) {
    engine::Server server(
        options([](const auto&, std::size_t, const std::atomic<bool>&) { return std::string("the source is gone"); }));
    Client client(server, true);
    const json scene = {
        {"dataset", "late"}, {"time", 1}, {"layers", {{"a", {{"type", "iso"}, {"array", "p"}, {"values", {5}}}}}}};
    client.request("scene.bounds", {{"scene", scene}, {"of", "drawn"}, {"progress", "mine"}});
    std::string stage;
    do {
        const json told = client.next_text();
        if (told["method"] == "call.progress") stage = told["params"]["stage"];
    } while (stage != "reading"); // next_text() throws if it never comes
}

} // namespace
} // namespace ciel::test
