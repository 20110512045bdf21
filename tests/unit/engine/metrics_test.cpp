#include "engine/metrics.hpp"

#include <ctime>
#include <gmock/gmock.h>
#include <regex>
#include <set>
#include <sstream>

namespace server::engine {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;

TEST(metrics, counts_what_happened) {
    Metrics metrics;
    metrics.count_frame(false, 1000, {1, 2, 3, 4});
    metrics.count_frame(true, 500, {0, 0, 1000, 0});
    metrics.count_cancelled_frame();
    metrics.count_request("scene.patch");
    metrics.count_request("scene.patch");
    metrics.count_error(-32602);
    const std::string text = metrics.text({.sessions = 3, .gl_renderer = "a \"GL\"", .backend = "osmesa"});
    EXPECT_THAT(text, HasSubstr("ciel_frames_total{kind=\"interactive\"} 1\n"));
    EXPECT_THAT(text, HasSubstr("ciel_frames_total{kind=\"still\"} 1\n"));
    EXPECT_THAT(text, HasSubstr("ciel_frames_cancelled_total 1\n"));
    EXPECT_THAT(text, HasSubstr("ciel_image_bytes_total 1500\n"));
    EXPECT_THAT(text, HasSubstr("ciel_frame_seconds_total{stage=\"draw\"} 1.00"));
    EXPECT_THAT(text, HasSubstr("ciel_rpc_requests_total{method=\"scene.patch\"} 2\n"));
    EXPECT_THAT(text, HasSubstr("ciel_rpc_errors_total{code=\"-32602\"} 1\n"));
    EXPECT_THAT(text, HasSubstr("ciel_sessions 3\n"));
    EXPECT_THAT(text, HasSubstr("renderer=\"a \\\"GL\\\"\",backend=\"osmesa\""));
}

// Prometheus text format 0.0.4: HELP and TYPE of a family stand directly before its samples.
TEST(metrics, follow_the_exposition_format) {
    Metrics metrics;
    metrics.count_frame(false, 1, {});
    metrics.count_request("scene.get");
    metrics.count_error(-32700);
    std::istringstream lines(metrics.text({}));
    const std::regex sample(
        R"re(([a-z_]+?)(_bucket|_sum|_count)?(\{[a-z]+="[^"]*"(,[a-z]+="[^"]*")*\})? [0-9.e+-]+)re");
    const std::regex help("# HELP ([a-z_]+) .+"), type("# TYPE ([a-z_]+) (counter|gauge|histogram)");
    bool is_histogram = false;
    std::set<std::string> families, with_samples;
    std::string line, family;
    std::smatch match;
    while (std::getline(lines, line)) {
        if (std::regex_match(line, match, help)) {
            family = match[1];
            EXPECT_TRUE(families.insert(family).second) << family << " twice";
            ASSERT_TRUE(std::getline(lines, line)) << family;
            ASSERT_TRUE(std::regex_match(line, match, type)) << line;
            EXPECT_EQ(match[1], family) << line;
            EXPECT_EQ(match[2] == "counter", family.ends_with("_total")) << family;
            is_histogram = match[2] == "histogram";
        } else {
            ASSERT_TRUE(std::regex_match(line, match, sample)) << line;
            EXPECT_EQ(match[1], family) << line;
            EXPECT_EQ(match[2].matched, is_histogram) << line;
            with_samples.insert(family);
        }
    }
    families.erase("ciel_call_duration_seconds"); // has no samples before the first call
    EXPECT_EQ(with_samples, families);
    EXPECT_THAT(families,
                IsSupersetOf({"ciel_frames_total", "ciel_rpc_requests_total", "ciel_rpc_errors_total", "ciel_sessions",
                              "ciel_dataset_bytes", "ciel_gl_info", "ciel_build_info", "process_cpu_seconds_total",
                              "process_open_fds", "process_max_fds", "process_virtual_memory_bytes",
                              "process_resident_memory_bytes", "process_start_time_seconds"}));
}

TEST(metrics, durations_are_counted_below_each_bound) {
    Metrics metrics;
    metrics.count_call("scene.get", 0.003);
    metrics.count_call("scene.get", 0.005);
    metrics.count_call("scene.get", 100);
    metrics.count_frame(true, 1, {900, 100, 200, 300});
    const std::string text = metrics.text({});
    const std::string bucket = "ciel_call_duration_seconds_bucket{method=\"scene.get\",le=";
    EXPECT_THAT(text, HasSubstr(bucket + "\"0.0025\"} 0\n"));
    EXPECT_THAT(text, HasSubstr(bucket + "\"0.005\"} 2\n")) << "a bound belongs to its bucket";
    EXPECT_THAT(text, HasSubstr(bucket + "\"60\"} 2\n"));
    EXPECT_THAT(text, HasSubstr(bucket + "\"+Inf\"} 3\n"));
    EXPECT_THAT(text, HasSubstr("ciel_call_duration_seconds_count{method=\"scene.get\"} 3\n"));
    EXPECT_THAT(text, HasSubstr("ciel_call_duration_seconds_sum{method=\"scene.get\"} 100.00"));
    const std::string stills = "ciel_frame_duration_seconds_bucket{kind=\"still\",le=";
    EXPECT_THAT(text, HasSubstr(stills + "\"0.5\"} 0\n"));
    EXPECT_THAT(text, HasSubstr(stills + "\"1\"} 1\n")) << "waiting is not part of it";
}

TEST(metrics, the_process_has_its_own_figures) {
    const std::string text = Metrics().text({.version = "1.2.3"});
    EXPECT_THAT(text, HasSubstr("ciel_build_info{version=\"1.2.3\",compiler="));
    const auto value = [&](const std::string& name) {
        const auto at = text.find("\n" + name + " ");
        return at == std::string::npos ? -1 : std::stod(text.substr(at + name.size() + 2));
    };
    EXPECT_GT(value("process_resident_memory_bytes"), 1e6);
    EXPECT_LT(value("process_resident_memory_bytes"), value("process_virtual_memory_bytes"));
    EXPECT_GT(value("process_open_fds"), 2);
    EXPECT_GT(value("process_start_time_seconds"), 1.6e9);
    EXPECT_LE(value("process_start_time_seconds"), static_cast<double>(std::time(nullptr)) + 1);
    EXPECT_GE(value("process_threads"), 1);
}

} // namespace
} // namespace server::engine
