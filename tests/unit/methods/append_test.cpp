// Uploaded time steps: refusals before the first piece, pieces in JSON and in binary messages, commits.
#include "service.hpp"

#include "engine/uploads.hpp"
#include "limits/errors.hpp"
#include "logging/log.hpp"
#include "methods/base64.hpp"
#include "store/writer.hpp"

#include <cstring>
#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

constexpr int not_found = -32001, limit = -32003, failed = -32005, not_allowed = -32007, invalid_params = -32602;

class Append : public testing::Test {
protected:
    explicit Append(const limits::Limits& limits = {}) : server_(options(limits)), client_(server_, true) {
        client_.give_token();
    }

    engine::ServerOptions options(const limits::Limits& limits) {
        if (!std::filesystem::exists(folder_ / "box.ciel")) write_small_dataset(folder_ / "box.ciel");
        engine::ServerOptions made;
        made.data = {folder_.path()};
        made.extraction = chosen_algorithm();
        made.limits = limits;
        made.allow_append = true;
        return made;
    }
    json begin(double time, json arrays = {{{"name", "p"}}}) {
        return client_.call("append.begin", {{"dataset", "box"}, {"time", time}, {"arrays", std::move(arrays)}});
    }
    std::string refusal(const std::string& method, json params, int code) {
        const json answer = client_.request(method, std::move(params));
        EXPECT_EQ(answer.value("/error/code"_json_pointer, 0), code) << answer;
        return answer.value("/error/data/reason"_json_pointer, std::string());
    }
    static Bytes bytes_of(const json& expected, float value) {
        Bytes bytes(expected["bytes"].get<std::size_t>());
        for (std::size_t i = 0; i < bytes.size(); i += sizeof value) std::memcpy(&bytes[i], &value, sizeof value);
        return bytes;
    }
    static json piece(const json& upload, std::size_t array, std::size_t offset, std::span<const std::uint8_t> bytes) {
        return {{"upload", upload["upload"]}, {"array", array}, {"offset", offset}, {"data", methods::base64(bytes)}};
    }
    // Sends every array of the upload in pieces of 1000 bytes.
    void fill(const json& upload, float value) {
        for (std::size_t i = 0; i < upload["arrays"].size(); ++i) {
            const Bytes bytes = bytes_of(upload["arrays"][i], value);
            for (std::size_t at = 0; at < bytes.size(); at += 1000) {
                const std::size_t size = std::min<std::size_t>(1000, bytes.size() - at);
                const json answer =
                    client_.call("append.piece", piece(upload, i, at, std::span(bytes).subspan(at, size)));
                EXPECT_EQ(answer["received"], at + size);
            }
        }
    }
    static json only(const json& upload) { return {{"upload", upload["upload"]}}; }
    json times() { return client_.call("dataset.describe", {{"dataset", "box"}})["times"]; }

    Folder folder_;
    engine::Server server_;
    Client client_;
};

TEST_F(Append, a_step_is_pushed_committed_and_seen_at_once) {
    const json upload = begin(3, {{{"name", "p"}}, {{"name", "U"}, {"components", 3}}, {{"name", "cell:w"}}});
    EXPECT_EQ(upload["arrays"][0]["association"], "point");
    EXPECT_EQ(upload["arrays"][1]["bytes"], 12 * upload["arrays"][1]["tuples"].get<int>());
    EXPECT_EQ(upload["arrays"][2]["association"], "cell");
    EXPECT_EQ(upload["made"], json({"w"}));
    EXPECT_EQ(upload["added"], json({"cell:w", "w"}));
    EXPECT_THAT(upload["lacking"], testing::UnorderedElementsAre("cell:q", "late"));
    fill(upload, 7);
    EXPECT_EQ(times(), json({0, 1, 2})) << "not before the commit";
    EXPECT_EQ(client_.call("append.commit", only(upload)), json({{"step", 3}, {"time", 3.0}}));
    EXPECT_EQ(times(), json({0, 1, 2, 3}));
    const json note = client_.next_text();
    EXPECT_EQ(note["method"], "dataset.changed");
    EXPECT_EQ(note["params"]["times"], json({0, 1, 2, 3}));
    const auto dataset = store::Dataset::open(folder_ / "box.ciel");
    EXPECT_THAT(dataset->values("p", 3), testing::Each(7.0F));
    EXPECT_THAT(dataset->values("w", 3), testing::Each(testing::DoubleNear(7, 1e-5)));
    EXPECT_EQ(server_.uploads().count(), 0U);
    refusal("append.commit", only(upload), not_found);
}

TEST_F(Append, a_commit_tells_how_far_it_is) {
    const json upload = begin(3, {{{"name", "p"}}, {{"name", "U"}, {"components", 3}}});
    fill(upload, 7);
    json commit = only(upload);
    commit["progress"] = "mine";
    EXPECT_EQ(client_.call("append.commit", commit)["step"], 3);
    json told = client_.next_text();
    EXPECT_EQ(told["method"], "call.progress");
    EXPECT_EQ(told["params"], json({{"progress", "mine"}, {"stage", "waiting"}, {"done", 0}, {"of", 0}}));
    told = client_.next_text();
    EXPECT_EQ(told["params"], json({{"progress", "mine"}, {"stage", "writing"}, {"done", 0}, {"of", 2}}));
}

TEST_F(Append, only_where_it_is_allowed_and_with_the_token) {
    Client stranger(server_, true);
    const json wanted{{"dataset", "box"}, {"time", 9}, {"arrays", {{{"name", "p"}}}}};
    const json id{{"upload", std::string(32, '0')}};
    json piece = id;
    piece.update({{"array", 0}, {"offset", 0}, {"data", ""}});
    const std::map<std::string, json> calls{
        {"append.begin", wanted}, {"append.piece", piece}, {"append.commit", id}, {"append.cancel", id}};
    for (const auto& [method, params] : calls) EXPECT_EQ(stranger.error_code(method, params), not_allowed) << method;
    EXPECT_THAT(
        stranger.send_bytes(Bytes(40)),
        testing::Optional(testing::HasSubstr("need `ciel serve --allow-append` and the server's token; send other")));

    engine::ServerOptions off = options({});
    off.allow_append = false;
    engine::Server server(std::move(off));
    Client client(server, false);
    client.give_token();
    for (const auto& [method, params] : calls) {
        const json answer = client.request(method, params);
        EXPECT_EQ(answer["error"]["code"], not_allowed) << method;
        EXPECT_THAT(answer["error"]["data"]["reason"].get<std::string>(), HasSubstr("--allow-append"));
    }
}

TEST_F(Append, malformed_uploads_are_refused_before_a_piece_is_taken) {
    const auto with = [](const char* member, json value) {
        json params{{"dataset", "box"}, {"time", 9}, {"arrays", {{{"name", "p"}}}}};
        params[member] = std::move(value);
        return params;
    };
    struct Row {
        json params;
        int code;
        const char* reason;
    };
    const std::vector<Row> rows{
        {with("dataset", "bax"), not_found, "bax"},
        {with("dataset", "../box"), not_found, "box"},
        {with("time", 2), failed, "not later than the last step of box, which is at time 2"},
        {with("time", "9"), invalid_params, "number"},
        {with("arrays", json::array()), invalid_params, "/arrays"},
        {with("arrays", {{{"name", "p"}}, {{"name", "p"}}}), failed, "given twice"},
        {with("arrays", {{{"name", "p"}, {"components", 3}}}), failed,
         "'p' has 1 components in the dataset, but the values have 3"},
        {with("arrays", {{{"name", "new"}, {"components", 65}}}), invalid_params, "components"},
        {with("arrays", {{{"name", "a/b"}}}), failed, "holds a '/'"},
        {with("arrays", {{{"name", "cell:.."}}}), failed, "is . or .."},
        {with("arrays", {{{"name", "x "}}}), failed, "begins or ends with a space"},
        {with("arrays", {{{"name", "a\nb"}}}), failed, "control character"},
        {with("arrays", {{{"name", ""}}}), invalid_params, "name"},
        {with("arrays", {{{"name", "p"}, {"file", "/etc/passwd"}}}), invalid_params, "file"},
    };
    for (const Row& row : rows) EXPECT_THAT(refusal("append.begin", row.params, row.code), HasSubstr(row.reason));
    EXPECT_EQ(server_.uploads().count(), 0U);
}

TEST_F(Append, malformed_pieces_are_refused_and_change_nothing) {
    const json upload = begin(3);
    const std::size_t size = upload["arrays"][0]["bytes"];
    const Bytes some(8);
    json params = piece(upload, 0, 0, some);
    EXPECT_EQ(client_.call("append.piece", params)["received"], 8);
    EXPECT_EQ(client_.call("append.piece", params)["received"], 8) << "the same again: its answer was lost";
    EXPECT_THAT(refusal("append.piece", piece(upload, 0, 9, some), failed), HasSubstr("would leave a gap"));
    EXPECT_THAT(refusal("append.piece", piece(upload, 1, 0, some), failed), HasSubstr("no array 1"));
    EXPECT_THAT(refusal("append.piece", piece(upload, 0, 8, Bytes(size)), failed), HasSubstr("is too long"));
    for (const char* data : {"AAA", "AAA=AAAA", "AA*A", "AAAB=", "====", "A===", "AB==", "AAB=", "AA A", "AAAA\n"}) {
        params["data"] = data;
        EXPECT_THAT(refusal("append.piece", params, invalid_params), HasSubstr("not base64")) << data;
    }
    params = piece(upload, 0, 0, some);
    for (const std::string& id : {std::string(32, '0'), std::string(32, 'A'), std::string(31, 'x') + "\n"}) {
        params["upload"] = id;
        EXPECT_THAT(refusal("append.piece", params, not_found), HasSubstr("there is no upload"));
    }
    params["upload"] = "short";
    refusal("append.piece", params, invalid_params);
    params = piece(upload, 0, 0, some);
    params["offset"] = -1;
    refusal("append.piece", params, invalid_params);
    EXPECT_THAT(refusal("append.commit", only(upload), failed),
                HasSubstr("has 8 of " + std::to_string(size) + " bytes"));
}

// A binary upload message (protocol/frame.md).
Bytes message(const json& upload, std::uint32_t array, std::uint64_t offset, std::span<const std::uint8_t> bytes) {
    Bytes made{'C', 'I', 'E', 'L', 1, 16, 0, 0};
    const wire::UploadId id = engine::upload_id(upload["upload"]);
    made.insert(made.end(), id.begin(), id.end());
    const auto put = [&](auto value) {
        for (std::size_t i = 0; i < sizeof value; ++i) made.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    put(array);
    put(static_cast<std::uint32_t>(bytes.size()));
    put(offset);
    made.insert(made.end(), bytes.begin(), bytes.end());
    return made;
}

TEST_F(Append, pieces_come_as_binary_messages_too) {
    const json upload = begin(3);
    const Bytes bytes = bytes_of(upload["arrays"][0], 2.5F);
    EXPECT_EQ(client_.send_bytes(message(upload, 0, 0, std::span(bytes).first(400))), std::nullopt);
    EXPECT_EQ(client_.send_bytes(message(upload, 0, 500, std::span(bytes).first(4))), std::nullopt);
    const json note = client_.next_text();
    EXPECT_EQ(note["method"], "append.refused");
    EXPECT_EQ(note["params"]["upload"], upload["upload"]);
    EXPECT_THAT(note["params"]["reason"].get<std::string>(), HasSubstr("gap"));
    EXPECT_FALSE(note["params"]["request"].get<std::string>().empty());
    EXPECT_EQ(client_.send_bytes(message(upload, 0, 400, std::span(bytes).subspan(400))), std::nullopt);
    EXPECT_EQ(client_.call("append.commit", only(upload))["step"], 3);
    EXPECT_THAT(store::Dataset::open(folder_ / "box.ciel")->values("p", 3), testing::Each(2.5F));
}

TEST_F(Append, a_binary_message_that_is_no_piece_ends_the_connection) {
    const Bytes good = message(begin(3), 0, 0, Bytes(4));
    const auto with = [&](std::size_t at, std::uint8_t byte) {
        Bytes bytes = good;
        bytes[at] = byte;
        return bytes;
    };
    for (const Bytes& bytes : {Bytes(), Bytes(39), with(0, 'X'), with(4, 2), with(5, 1), with(6, 1), with(7, 1),
                               with(28, 5), with(31, 255), Bytes(good.begin(), good.end() - 1)})
        EXPECT_NE(client_.send_bytes(bytes), std::nullopt);
    EXPECT_EQ(client_.send_bytes(good), std::nullopt);
}

TEST_F(Append, a_binary_message_that_is_refused_has_a_line_in_the_log) {
    const Bytes good = message(begin(3), 0, 0, Bytes(4));
    Client stranger(server_, true);
    testing::internal::CaptureStderr();
    logging::start_log("info", logging::LogFormat::text);
    EXPECT_NE(client_.send_bytes(Bytes(39)), std::nullopt);
    EXPECT_THAT(stranger.send_bytes(good).value_or(""), testing::HasSubstr("the server's token"));
    logging::start_log("off", logging::LogFormat::text);
    const std::string log = testing::internal::GetCapturedStderr();
    EXPECT_THAT(log, testing::ContainsRegex("call failed method=append.piece code=-[0-9]+ reason=\".*\" request="));
    EXPECT_EQ(std::ranges::count(log, '\n'), 2) << log;
}

TEST_F(Append, a_commit_without_memory_for_its_values_is_refused_and_can_be_repeated) {
    std::uint64_t others = 0;
    limits::Memory memory(
        100'000, [&] { return others; }, [] {});
    const limits::Limits limits;
    engine::Uploads uploads(limits, memory);
    const auto begun = uploads.begin("box", server_.services().catalog.open("box"), 3, {{"p", {}, false}});
    const Bytes bytes(engine::upload_bytes(begun.plan.arrays[0]));
    uploads.add({begun.id, 0, 0, bytes});
    others = 100'000 - bytes.size();
    const auto commit = [&] { return uploads.commit(begun.id, [](std::size_t, std::size_t) {}); };
    EXPECT_THROW(commit(), limits::LimitReached);
    EXPECT_EQ(uploads.count(), 1U);
    others = 0;
    EXPECT_EQ(commit().step, 3U);
    EXPECT_EQ(memory.bytes(limits::Held::uploads), 0U);
}

TEST_F(Append, two_uploads_at_once_do_not_mix_and_the_later_time_wins) {
    const json first = begin(3), second = begin(4), third = begin(3.5);
    fill(second, 4);
    fill(first, 3);
    fill(third, 5);
    EXPECT_EQ(client_.call("append.commit", only(first))["step"], 3);
    EXPECT_EQ(client_.call("append.commit", only(second))["step"], 4);
    EXPECT_THAT(refusal("append.commit", only(third), failed),
                HasSubstr("not later than the last step of box, which is at time 4"));
    const auto dataset = store::Dataset::open(folder_ / "box.ciel");
    EXPECT_THAT(dataset->values("p", 3), testing::Each(3.0F));
    EXPECT_THAT(dataset->values("p", 4), testing::Each(4.0F));
    EXPECT_EQ(dataset->steps().size(), 5U);
}

TEST_F(Append, the_lock_is_held_for_the_commit_only_and_one_that_fails_can_be_tried_again) {
    const json upload = begin(5);
    fill(upload, 1);
    {
        store::Writer other = store::Writer::append(folder_ / "box.ciel");
        const std::string reason = refusal("append.commit", only(upload), failed);
        EXPECT_THAT(reason, HasSubstr("being appended to by another process"));
        EXPECT_THAT(reason, testing::Not(HasSubstr(folder_.path().string()))) << "nobody elsewhere needs to know";
    }
    EXPECT_EQ(client_.call("append.commit", only(upload))["step"], 3);
}

TEST_F(Append, an_upload_that_is_being_stored_cannot_be_cancelled) {
    const json upload = begin(5);
    fill(upload, 1);
    const engine::UploadId id = engine::upload_id(upload["upload"]);
    std::string reason;
    server_.uploads().commit(
        id, [&](std::size_t, std::size_t) { reason = refusal("append.cancel", only(upload), failed); });
    EXPECT_THAT(reason, HasSubstr("is being stored"));
    EXPECT_EQ(store::Dataset::open(folder_ / "box.ciel")->steps().size(), 4U);
    refusal("append.cancel", only(upload), not_found);
}

TEST_F(Append, an_upload_is_forgotten_when_it_is_cancelled_or_silent) {
    const json cancelled = begin(3), silent = begin(4);
    EXPECT_EQ(client_.call("append.cancel", only(cancelled)), nullptr);
    refusal("append.commit", only(cancelled), not_found);
    const auto now = engine::Uploads::Clock::now();
    server_.tidy(now + std::chrono::seconds(59));
    EXPECT_EQ(server_.uploads().count(), 1U);
    EXPECT_GT(server_.uploads().bytes(), 0U);
    server_.tidy(now + std::chrono::seconds(61));
    EXPECT_EQ(server_.uploads().count(), 0U);
    EXPECT_THAT(refusal("append.piece", piece(silent, 0, 0, Bytes(4)), not_found),
                HasSubstr("without a piece for 60 s"));
}

class AppendLimits : public Append {
protected:
    static limits::Limits small() {
        limits::Limits limits;
        limits.uploads = 2;
        limits.upload_bytes = 10000;
        limits.upload_piece_bytes = 100;
        return limits;
    }
    AppendLimits() : Append(small()) {}
};

TEST_F(AppendLimits, have_sentences) {
    const json wanted{{"dataset", "box"}, {"time", 3}, {"arrays", {{{"name", "new"}, {"components", 64}}}}};
    EXPECT_THAT(refusal("append.begin", wanted, limit), HasSubstr("an upload may have"));
    const json upload = begin(3);
    EXPECT_EQ(upload["piece_bytes"], 100);
    EXPECT_THAT(refusal("append.piece", piece(upload, 0, 0, Bytes(101)), limit), HasSubstr("100 bytes"));
    (void)begin(4);
    const json third{{"dataset", "box"}, {"time", 5}, {"arrays", {{{"name", "p"}}}}};
    EXPECT_THAT(refusal("append.begin", third, limit), HasSubstr("2 uploads are open already"));
    client_.call("append.cancel", only(upload));
    EXPECT_NO_THROW((void)begin(5));
}

} // namespace
} // namespace ciel::test
