#include "logging/log.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <spdlog/spdlog.h>

namespace server::logging {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

template <class Write>
std::string logged(LogFormat format, Write write, const std::string& level = "info") {
    testing::internal::CaptureStderr();
    start_log(level, format);
    write();
    return testing::internal::GetCapturedStderr();
}

const std::regex utc(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");

void call_failed() {
    log_event(
        LogLevel::warning, "call failed",
        {{"method", "scene.get"}, {"user", ""}, {"reason", "there is \"none\"\nof it"}, {"code", -32001}, {"ms", 1.5}});
}

TEST(log, a_line_of_text_has_the_event_and_what_is_known) {
    const std::string line = logged(LogFormat::text, call_failed);
    EXPECT_TRUE(std::regex_search(line, utc, std::regex_constants::match_continuous)) << line;
    EXPECT_THAT(
        line,
        HasSubstr(" call failed method=scene.get reason=\"there is \\\"none\\\"\\nof it\" code=-32001 ms=1.500\n"));
    EXPECT_THAT(line, Not(HasSubstr("user")));
}

TEST(log, a_line_of_json_is_one_object) {
    const std::string line = logged(LogFormat::json, call_failed);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
    const json event = json::parse(line);
    EXPECT_TRUE(std::regex_match(event["time"].get<std::string>(), utc)) << line;
    EXPECT_EQ(event["level"], "warning");
    EXPECT_EQ(event["event"], "call failed");
    EXPECT_EQ(event["reason"], "there is \"none\"\nof it");
    EXPECT_EQ(event["code"], -32001);
    EXPECT_EQ(event["ms"], 1.5);
    EXPECT_FALSE(event.contains("user"));
}

TEST(log, what_others_log_has_the_same_form) {
    const auto write = [] { spdlog::info("dataset {}", "a\nb {}"); };
    EXPECT_EQ(json::parse(logged(LogFormat::json, write))["event"], "dataset a\nb {}");
    const std::string line = logged(LogFormat::text, write);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
}

TEST(log, what_others_log_has_no_fields) {
    const auto write = [] {
        spdlog::info("dataset {}", "a\x1f"
                                   "b=1\x1fx\n2026 error");
    };
    const std::string line = logged(LogFormat::text, write);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
    const json event = json::parse(logged(LogFormat::json, write));
    EXPECT_EQ(event.size(), 3U) << "time, level and event: " << event;
    EXPECT_EQ(event["event"], "dataset a\x1f"
                              "b=1\x1fx\n2026 error");
}

TEST(log, no_value_makes_another_line_or_a_long_one) {
    const auto write = [] {
        log_event(LogLevel::info, "{} %s", {{"reason", "\x1f x=1\n2026 \xff" + std::string(5000, 'a')}});
    };
    for (const LogFormat format : {LogFormat::text, LogFormat::json}) {
        const std::string line = logged(format, write);
        EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
        EXPECT_LT(line.size(), 600U);
        EXPECT_THAT(line, HasSubstr("{} %s"));
    }
    EXPECT_THAT(json::parse(logged(LogFormat::json, write))["reason"].get<std::string>(), HasSubstr("\x1f x=1"));
}

TEST(log, a_level_that_is_not_wanted_is_not_written) {
    EXPECT_EQ(logged(
                  LogFormat::text, [] { log_event(LogLevel::info, "event", {}); }, "warn"),
              "");
    EXPECT_EQ(logged(
                  LogFormat::text, [] { log_event(LogLevel::error, "event", {}); }, "off"),
              "");
}

TEST(log, ids_of_requests_differ_and_those_of_sessions_are_cut) {
    EXPECT_NE(next_request_id(), next_request_id());
    EXPECT_EQ(short_id("0123456789abcdef"), "01234567");
    EXPECT_EQ(short_id("abc"), "abc");
}

} // namespace
} // namespace server::logging
