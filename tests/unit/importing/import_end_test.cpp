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

} // namespace
} // namespace server::importing
