#include "ciel/types.hpp"
#include "processes/child_process.hpp"

#include <chrono>
#include <csignal>
#include <gmock/gmock.h>

namespace server::processes {
using namespace ciel;
namespace {

const std::atomic<bool> never{false};

processes::ChildEnd shell(
    const std::string& script, const processes::ChildLimits& limits = {},
    const std::function<void(std::string_view)>& on_line = [](std::string_view) {},
    const std::atomic<bool>& cancel = never) {
    return processes::run_child({"/bin/sh", "-c", script}, limits, on_line, cancel);
}

TEST(ChildProcess, lines_errors_and_exit_code_come_through) {
    std::vector<std::string> lines;
    const auto end = shell("echo one; echo wrong >&2; printf 'two\\nno end'; exit 7", {},
                           [&](std::string_view line) { lines.emplace_back(line); });
    EXPECT_THAT(lines, ::testing::ElementsAre("one", "two"));
    EXPECT_EQ(end.exit_code, 7);
    EXPECT_EQ(end.errors, "wrong\n");
    EXPECT_FALSE(end.cancelled || end.timed_out);
}

TEST(ChildProcess, a_crash_is_told_from_an_exit) {
    const auto end = shell("kill -SEGV $$");
    EXPECT_EQ(end.signal, SIGSEGV);
    EXPECT_EQ(end.exit_code, -1);
}

TEST(ChildProcess, a_program_that_does_not_exist_ends_with_127) {
    EXPECT_EQ(processes::run_child(
                  {"/nowhere/program"}, {}, [](std::string_view) {}, never)
                  .exit_code,
              127);
}

TEST(ChildProcess, the_time_limit_ends_it) {
    const auto end = shell("exec sleep 600", {0, 0.2});
    EXPECT_TRUE(end.timed_out);
    EXPECT_EQ(end.signal, SIGTERM);
}

TEST(ChildProcess, one_that_makes_no_progress_is_ended) {
    for (const char* script : {"exec sleep 600", "while :; do :; done"}) {
        const auto end = shell(script, {0, 0, 0.2});
        EXPECT_TRUE(end.stalled) << script;
        EXPECT_FALSE(end.timed_out) << script;
        EXPECT_EQ(end.signal, SIGTERM) << script;
    }
}

TEST(ChildProcess, lines_are_progress) {
    const auto end = shell("for i in 1 2 3 4 5 6 7 8 9 10; do echo $i; sleep 0.1; done", {0, 0, 0.8});
    EXPECT_FALSE(end.stalled);
    EXPECT_EQ(end.exit_code, 0);
}

TEST(ChildProcess, reading_without_a_line_is_progress_for_a_while) {
    const std::string read = "head -c 100000 /dev/zero >/dev/null; sleep 0.05";
    const auto end =
        shell("for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do " + read + "; done", {0, 0, 0.5});
    EXPECT_FALSE(end.stalled);
    EXPECT_TRUE(shell("while :; do " + read + "; done", {0, 0, 0.3}).stalled) << "but not for ever";
}

TEST(ChildProcess, cancelling_ends_it_even_when_it_has_closed_its_streams) {
    std::atomic<bool> cancel{false};
    const auto end = shell(
        "echo go; exec sleep 600 >&- 2>&-", {}, [&](std::string_view) { cancel = true; }, cancel);
    EXPECT_TRUE(end.cancelled);
    EXPECT_EQ(end.signal, SIGTERM);
}

TEST(ChildProcess, one_that_ignores_the_request_is_killed) {
    const auto end = shell("trap '' TERM; while :; do sleep 1; done", {0, 0.2});
    EXPECT_TRUE(end.timed_out);
    EXPECT_EQ(end.signal, SIGKILL);
}

TEST(ChildProcess, the_memory_limit_holds) {
    const auto end = shell("exec /usr/bin/python3 -c 'b\"x\" * (1 << 30)'", {512U << 20, 0});
    EXPECT_EQ(end.exit_code, 1);
    EXPECT_THAT(end.errors, ::testing::HasSubstr("MemoryError"));
}

// A large dataset is mapped to be checked after its import. Mapped files are not memory of the process.
TEST(ChildProcess, what_is_mapped_to_be_read_does_not_count_as_memory) {
    const auto end = shell("exec /usr/bin/python3 -c 'import mmap; m = mmap.mmap(-1, 1 << 30, flags=mmap.MAP_PRIVATE, "
                           "prot=mmap.PROT_READ); print(m[0])'",
                           {512U << 20, 0});
    EXPECT_EQ(end.exit_code, 0) << end.errors;
}

TEST(ChildProcess, an_exception_of_the_listener_ends_the_child) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW((void)shell("echo go; exec sleep 600", {}, [](std::string_view) { throw Error("enough"); }), Error);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(5));
}

} // namespace
} // namespace server::processes
