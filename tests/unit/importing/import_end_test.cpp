// The sentence about an import that failed: what it names, and what became of the dataset.
#include "importing/import_end.hpp"

#include <csignal>
#include <gmock/gmock.h>

namespace server::importing {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

processes::ChildEnd crashed(int signal = SIGSEGV) {
    processes::ChildEnd end;
    end.signal = signal;
    return end;
}

TEST(ImportEnd, OfAWholeImportLeavesNothing) {
    const std::string sentence = describe_end(crashed(), {{"inputs", {"box.vtu"}}, {"step", {}}}, {});
    EXPECT_THAT(sentence, StartsWith("box.vtu: the reader crashed"));
    EXPECT_THAT(sentence, EndsWith("; nothing was written"));
}

TEST(ImportEnd, AFailedDiskIsNoDamagedFile) {
    const std::string sentence = describe_end(crashed(SIGBUS), {{"inputs", {"box.vtu"}}}, {});
    EXPECT_THAT(sentence, HasSubstr("a disk failed"));
    EXPECT_THAT(sentence, Not(HasSubstr("damaged")));
    EXPECT_THAT(sentence, EndsWith("; nothing was written"));
}

TEST(ImportEnd, OfLateStepsKeepsThoseThatWereRead) {
    for (const char* option : {"step", "all"}) {
        const std::string sentence = describe_end(crashed(), {{"inputs", {"box.ciel"}}, {option, {"3"}}}, {});
        EXPECT_THAT(sentence, StartsWith("the source of box.ciel: the reader crashed")) << option;
        EXPECT_THAT(sentence, EndsWith("; steps that were read before are kept")) << option;
    }
}

TEST(ImportEnd, KnowsTheSentencesOfTheDynamicLoaderForTooLittleMemory) {
    for (const char* reason :
         {"libc.so.6: failed to map segment from shared object", "libm.so.6: cannot map zero-fill pages",
          "libz.so.1: cannot create shared object descriptor: Cannot allocate memory"}) {
        processes::ChildEnd end;
        end.exit_code = 127;
        end.errors = std::string("/usr/bin/ciel-import: error while loading shared libraries: ") + reason;
        EXPECT_THAT(describe_end(end, {{"inputs", {"box.vtu"}}}, {}), HasSubstr("the memory limit of")) << reason;
    }
}

TEST(ImportEnd, NamesTheOptionThatCanBeGiven) {
    processes::ChildEnd out_of_memory, stalled;
    out_of_memory.exit_code = import_out_of_memory;
    stalled.stalled = true;
    const ImportValues values{{"inputs", {"box.vtu"}}};
    EXPECT_THAT(describe_end(out_of_memory, values, {}), HasSubstr("raise the limit with --memory-limit"));
    EXPECT_THAT(describe_end(stalled, values, {}), HasSubstr("no progress for 1800 s and was stopped"));
    EXPECT_THAT(describe_end(stalled, values, {}), HasSubstr("a longer --stall-limit"));

    ImportLimits of_user;
    of_user.stalled_seconds = 999.7;
    EXPECT_THAT(describe_end(stalled, values, of_user), HasSubstr("no progress for 1000 s and was stopped"));

    limits::Limits of_server;
    of_server.import_memory_bytes = 3'000'000'000;
    of_server.import_stalled_seconds = 7;
    const ImportLimits limits = import_limits_of_server(of_server);
    EXPECT_THAT(describe_end(out_of_memory, values, limits),
                HasSubstr("limit of 3 GB was reached; raise the limit with --limit-import-memory-bytes"));
    EXPECT_THAT(describe_end(stalled, values, limits), HasSubstr("no progress for 7 s and was stopped"));
    EXPECT_THAT(describe_end(stalled, values, limits), HasSubstr("a longer --limit-import-stalled-seconds"));
}

} // namespace
} // namespace server::importing
