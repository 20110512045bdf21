// The table of limits: names, values as text, and defaults that depend on the machine's memory.
#include "limits/limits.hpp"

#include "ciel/types.hpp"
#include "limits/machine_memory.hpp"

#include <gmock/gmock.h>
#include <set>

namespace server::limits {
using namespace ciel;
namespace {

const LimitRow& row_of(std::string_view name) {
    for (const auto& row : limit_rows())
        if (row.name == name) return row;
    throw Error("no such row");
}

std::string problem(std::string_view name, std::string_view text) {
    try {
        (void)parse_limit(row_of(name), text);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Limits, what_a_server_without_options_grants) {
    const Limits limits;
    EXPECT_EQ(limits.reserved_connections, 32U);
    EXPECT_EQ(limits.head_seconds, 5U);
    EXPECT_EQ(limits.wrong_token_seconds, 1U);
    EXPECT_EQ(limits.wrong_tokens_waiting, 16U);
    EXPECT_EQ(limits.scene_bytes, 1U << 20);
    EXPECT_EQ(limits.history_bytes, 8U << 20);
    EXPECT_EQ(limits.batch_answer_bytes, 64U << 20);
    EXPECT_EQ(limits.unsent_bytes, 32U << 20);
    EXPECT_EQ(limits.upload_piece_bytes, 512U << 10);
    EXPECT_EQ(limits.upload_idle_seconds, 60U);
    EXPECT_EQ(limits.late_step_seconds, 60U);
    EXPECT_EQ(limits.import_memory_bytes, machine_memory() / 100 * 80);
    EXPECT_EQ(limits.import_stalled_seconds, 1800U);
    EXPECT_EQ(limits.hang_seconds, 60U);
    EXPECT_EQ(limits.drain_seconds, 1U);
}

TEST(Limits, each_member_has_one_row_with_a_name_of_its_own_and_a_default_in_its_range) {
    Limits limits;
    std::set<std::string_view> names;
    std::set<const std::uint64_t*> members;
    for (const auto& row : limit_rows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(members.insert(&(limits.*row.member)).second) << row.name;
        EXPECT_FALSE(row.description.empty()) << row.name;
        EXPECT_GE(row.least, 1U) << row.name;
        EXPECT_GE(limits.*row.member, row.least) << row.name;
        EXPECT_LE(limits.*row.member, row.most) << row.name;
    }
    EXPECT_EQ(members.size() * sizeof(std::uint64_t), sizeof(Limits));
}

TEST(Limits, have_an_option_and_a_variable_by_their_name) {
    EXPECT_EQ(option_of(row_of("message_bytes")), "--limit-message-bytes");
    EXPECT_EQ(environment_of(row_of("message_bytes")), "CIEL_LIMIT_MESSAGE_BYTES");
}

TEST(Limits, are_read_as_numbers_sizes_and_shares_of_memory) {
    EXPECT_EQ(parse_limit(row_of("sessions"), "7"), 7U);
    EXPECT_EQ(parse_limit(row_of("message_bytes"), "64K"), 65536U);
    EXPECT_EQ(parse_limit(row_of("message_bytes"), "3M"), 3U << 20);
    EXPECT_EQ(parse_limit(row_of("dataset_memory_bytes"), "2T"), std::uint64_t{2} << 40);
    EXPECT_EQ(parse_limit(row_of("dataset_memory_bytes"), "25%"), machine_memory() / 100 * 25);
}

TEST(Limits, that_the_contract_has_too_are_at_most_those_of_the_contract) {
    EXPECT_THAT(problem("layers", "65"), testing::HasSubstr("64"));
    EXPECT_THAT(problem("values_per_layer", "65"), testing::HasSubstr("64"));
    EXPECT_THAT(problem("image_side", "8193"), testing::HasSubstr("8192"));
    EXPECT_THAT(problem("histogram_bins", "4097"), testing::HasSubstr("4096"));
}

TEST(Limits, of_memory_are_shares_of_the_machines) {
    const Limits limits;
    for (const auto& row : limit_rows()) {
        if (row.unit != LimitRow::Unit::memory) continue;
        EXPECT_LT(limits.*row.member, machine_memory()) << row.name;
    }
    EXPECT_EQ(limits.dataset_memory_bytes, memory_share(40));
}

TEST(Limits, that_make_no_sense_are_refused_in_a_sentence) {
    EXPECT_EQ(problem("sessions", "0"), "0 is not between 1 and 1000000");
    EXPECT_EQ(problem("histogram_bins", "5000"), "5000 is not between 1 and 4096");
    EXPECT_EQ(problem("sessions", "1K"), "1K is not a whole number; give a whole number");
    EXPECT_EQ(problem("message_bytes", "-1"), "-1 is not a whole number; give a size such as 64M");
    EXPECT_EQ(problem("message_bytes", "25%"), "25% is not a whole number; give a size such as 64M");
    EXPECT_EQ(problem("dataset_memory_bytes", "101%"), "101% is not a whole number; give a size such as 64M or 25%");
    EXPECT_EQ(problem("message_bytes", ""), " is not a whole number; give a size such as 64M");
    EXPECT_EQ(problem("message_bytes", "18446744073709551615T"),
              "18446744073709551615T is not between 4 KiB and 1024 TiB");
}

TEST(Limits, are_told_with_their_unit) {
    EXPECT_EQ(limit_text(row_of("sessions"), 64), "64");
    EXPECT_EQ(limit_text(row_of("drain_seconds"), 10), "10 s");
    EXPECT_EQ(limit_text(row_of("image_side"), 8192), "8192 pixels");
    EXPECT_EQ(limit_text(row_of("message_bytes"), 1 << 20), "1 MiB");
    EXPECT_EQ(limit_text(row_of("message_bytes"), 1000), "1000 bytes");
    EXPECT_EQ(limit_text(row_of("session_memory_bytes"), 2'516'582'401), "2400 MiB");
}

} // namespace
} // namespace server::limits
