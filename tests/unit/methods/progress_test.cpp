// Tests call.progress: its stages, and the connections that receive it.
#include "methods.hpp"

#include <gmock/gmock.h>

namespace ciel::test {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::Gt;
using testing::HasSubstr;
using testing::StrEq;

struct Told {
    std::string name, stage;
    int done, of;
};

class CallProgress : public Methods {
protected:
    // Returns what a client is told up to the stage "writing", the last one.
    static std::vector<Told> heard_by(Client& listener) {
        std::vector<Told> all;
        do {
            const json text = listener.next_text();
            if (text["method"] != "call.progress") continue;
            const json& told = text["params"];
            all.push_back({told["progress"], told["stage"], told["done"], told["of"]});
        } while (all.empty() || all.back().stage != "writing");
        return all;
    }
    static std::vector<std::string> stages(const std::vector<Told>& all) {
        std::vector<std::string> names;
        for (const Told& one : all)
            if (names.empty() || names.back() != one.stage) names.push_back(one.stage);
        return names;
    }
    // Calls a method and returns what the caller is told.
    std::vector<Told> told_by(const std::string& method, json params) {
        params["progress"] = "mine";
        client.call(method, params);
        json last = picture(in_session({}));
        last["progress"] = "last";
        client.call("picture.render", last);
        std::vector<Told> all = heard_by(client);
        std::erase_if(all, [](const Told& one) { return one.name == "last"; });
        return all;
    }
    std::vector<std::string> stages_of(const std::string& method, const json& params) {
        return stages(told_by(method, params));
    }
    static json picture(json params) {
        params.update({{"width", 16}, {"height", 16}, {"progress", "mine"}});
        return params;
    }
};

TEST_F(CallProgress, OfAPictureHasItsStagesAndLayers) {
    client.call("picture.render", picture(in_session({})));
    const std::vector<Told> told = heard_by(client);
    EXPECT_THAT(stages(told), ElementsAre("surfaces", "waiting", "drawing", "writing"));
    EXPECT_THAT(told, Each(Field(&Told::name, StrEq("mine"))));
    EXPECT_EQ(told[0].done, 0);
    EXPECT_EQ(told[0].of, 3) << "the layers that are visible";
    EXPECT_EQ(told.back().of, 0);
}

TEST_F(CallProgress, OfAnExportHasItsStages) {
    client.call("surface.export", in_session({{"layer", "iso"}, {"format", "ply"}, {"progress", "mine"}}));
    EXPECT_THAT(stages(heard_by(client)), ElementsAre("surfaces", "writing"));
}

TEST_F(CallProgress, OfCallsThatMeasureHasTheirStages) {
    const json seen = in_session({{"width", 16}, {"height", 16}});
    json pixel = seen;
    pixel["pixel"] = {8, 8};
    EXPECT_THAT(stages_of("scene.camera", seen), ElementsAre("surfaces"));
    EXPECT_THAT(stages_of("scene.pick", pixel), ElementsAre("surfaces", "measuring"));
    EXPECT_THAT(stages_of("scene.bounds", in_session({})), ElementsAre("surfaces", "measuring"));
    EXPECT_THAT(stages_of("color.range", in_session({{"layers", {"iso"}}})), ElementsAre("surfaces", "measuring"));
    EXPECT_THAT(stages_of("probe.point", pixel), ElementsAre("surfaces", "measuring", "waiting", "measuring"));
    EXPECT_THAT(stages_of("probe.point", in_session({{"position", {1003, 3, -47}}})), ElementsAre("measuring"));
    EXPECT_THAT(stages_of("dataset.histogram", {{"dataset", "box"}, {"array", "p"}}), ElementsAre("measuring"));
}

// With three bins, the stored histogram is of no use, and all values are read.
TEST_F(CallProgress, OfAHistogramCountsTheValuesThatAreRead) {
    const auto told = told_by("dataset.histogram", {{"dataset", "box"}, {"array", "p"}, {"bins", 3}});
    EXPECT_THAT(told, Contains(Field(&Told::of, Gt(0))));
    EXPECT_THAT(told, Contains(Field(&Told::done, Gt(0))));
}

TEST_F(CallProgress, OfAHistogramEndsWithItsConnection) {
    std::stop_source stop;
    const auto connection = std::make_shared<sessions::Connection>();
    connection->stop = stop.get_token();
    connection->send_binary = [](const auto&) {};
    connection->send_text = [&](const std::string& text) {
        if (text.find("measuring") != std::string::npos) stop.request_stop();
    };
    std::promise<std::string> answer;
    methods::dispatch(
        server, connection,
        Client::request_of("dataset.histogram", {{"dataset", "box"}, {"array", "p"}, {"bins", 3}, {"progress", "x"}})
            .dump(),
        [&](std::string text) { answer.set_value(std::move(text)); });
    EXPECT_THAT(answer.get_future().get(), HasSubstr("the connection ended before the answer"));
}

TEST_F(CallProgress, IsToldToTheCallerOfAGivenScene) {
    json scene = scene_with_iso();
    scene["layers"]["surface"]["visible"] = false;
    client.call("picture.render", picture({{"scene", scene}}));
    EXPECT_EQ(heard_by(client)[0].of, 2);
}

TEST_F(CallProgress, OfAPostIsToldToAllOfItsSession) {
    Client other(server, true), stranger(server, true), script(server, false);
    other.call("session.open", {{"session", session}});
    script.call("picture.render", picture(in_session({})));
    EXPECT_THAT(stages(heard_by(client)), ElementsAre("surfaces", "waiting", "drawing", "writing"));
    EXPECT_THAT(stages(heard_by(other)), ElementsAre("surfaces", "waiting", "drawing", "writing"));
    json own = picture({{"scene", {{"dataset", "box"}}}});
    own["progress"] = "own";
    stranger.call("picture.render", own);
    EXPECT_THAT(heard_by(stranger), Each(Field(&Told::name, StrEq("own"))));
}

TEST_F(CallProgress, IsNotToldUnlessAskedFor) {
    client.call("picture.render", in_session({{"width", 16}, {"height", 16}}));
    json named = picture(in_session({}));
    named["progress"] = "second";
    client.call("picture.render", named);
    EXPECT_THAT(heard_by(client), Each(Field(&Told::name, StrEq("second"))));
}

TEST_F(CallProgress, HasANameOfAtMost64Characters) {
    for (const std::string& name : {std::string(), std::string(65, 'x')}) {
        json call = picture(in_session({}));
        call["progress"] = name;
        EXPECT_EQ(client.error_code("picture.render", call), -32602) << name.size();
    }
}

} // namespace
} // namespace ciel::test
