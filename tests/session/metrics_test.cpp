#include "session/mailbox.hpp"
#include "session/metrics.hpp"

#include <gmock/gmock.h>
#include <regex>
#include <set>
#include <sstream>

namespace ciel::session {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;

TEST(mailbox, the_newest_wins) {
    Mailbox<int> mailbox;
    EXPECT_TRUE(mailbox.empty());
    EXPECT_FALSE(mailbox.take());
    mailbox.put(1);
    mailbox.put(2);
    EXPECT_EQ(mailbox.take(), 2);
    EXPECT_TRUE(mailbox.empty());
}

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

// The exposition format 0.0.4: each sample belongs to a family that HELP and TYPE have introduced just before.
TEST(metrics, follow_the_exposition_format) {
    Metrics metrics;
    metrics.count_frame(false, 1, {});
    metrics.count_request("scene.get");
    metrics.count_error(-32700);
    std::istringstream lines(metrics.text({}));
    const std::regex sample(R"re(([a-z_]+)(\{[a-z]+="[^"]*"(,[a-z]+="[^"]*")*\})? [0-9.e+-]+)re");
    const std::regex help("# HELP ([a-z_]+) .+"), type("# TYPE ([a-z_]+) (counter|gauge)");
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
        } else {
            ASSERT_TRUE(std::regex_match(line, match, sample)) << line;
            EXPECT_EQ(match[1], family) << line;
            with_samples.insert(family);
        }
    }
    EXPECT_EQ(with_samples, families);
    EXPECT_THAT(families, IsSupersetOf({"ciel_frames_total", "ciel_rpc_requests_total", "ciel_rpc_errors_total",
                                        "ciel_sessions", "ciel_dataset_bytes", "ciel_gl_info"}));
}

} // namespace
} // namespace ciel::session
