// The number of files that an append inspects, and temporary files that killed appends have left.
#include "support/store_box/box.hpp"
#include "unit/store/counted_stat.hpp"

#include "store/files/files.hpp"

#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

const ArrayInfo p_info{"p", Association::point, 1, "Pa", ""}, q_info{"q", Association::point, 1, "", ""};

// Writes a dataset with the times 0, 1, ... and the arrays p and q.
void write_steps(const fs::path& directory, std::size_t steps) {
    const FaceMesh mesh = test::box(1, 1, 1);
    Writer writer(directory, {"box.vtu", "m", 8, 12, 1, {}});
    writer.add_mesh(mesh, test::identity(8), test::identity(1), {});
    for (std::size_t step = 0; step < steps; ++step) {
        const auto values = test::values_of(8, step);
        writer.add_step(static_cast<double>(step), 0, 0, std::vector<ArrayValues>{{p_info, values}, {q_info, values}});
    }
    writer.finish();
}

void append_step(const fs::path& directory, double time) {
    const auto values = test::values_of(8, 1);
    Writer::append(directory).add_step(time, 0, 0, std::vector<ArrayValues>{{p_info, values}, {q_info, values}});
}

template <typename Work>
std::size_t stat_calls_of(const Work& work) {
    const std::size_t before = test::stat_calls();
    work();
    return test::stat_calls() - before;
}

// The number of inspected files must not grow with the number of steps. Both datasets have a table of steps.
TEST(AppendFiles, TheFilesOfOldStepsAreNotAskedFor) {
    const test::Folder scratch;
    std::vector<std::size_t> writing, reading;
    for (const std::size_t steps : {70, 700}) {
        const fs::path directory = scratch / (std::to_string(steps) + ".ciel");
        write_steps(directory, steps);
        const auto reader = Dataset::open(directory);
        writing.push_back(stat_calls_of([&] { append_step(directory, 1000); }));
        reading.push_back(stat_calls_of([&] { EXPECT_EQ(reader->refreshed()->steps().size(), steps + 1); }));
    }
    EXPECT_GT(writing[0], 10U) << "they are counted";
    EXPECT_EQ(writing[0], writing[1]);
    EXPECT_EQ(reading[0], reading[1]);
}

TEST(AppendFiles, AReaderLooksAtNoFileOfAStepBeforeItIsShown) {
    const test::Folder scratch;
    write_steps(scratch / "few.ciel", 70);
    write_steps(scratch / "many.ciel", 700);
    const std::size_t one = stat_calls_of([&] { (void)Dataset::open(scratch / "few.ciel"); });
    EXPECT_GT(one, 0U) << "they are counted";
    EXPECT_EQ(stat_calls_of([&] { (void)Dataset::open(scratch / "many.ciel"); }), one);
    const auto reader = Dataset::open(scratch / "few.ciel");
    append_step(scratch / "few.ciel", 100);
    const std::size_t first = stat_calls_of([&] { (void)reader->refreshed(); });
    append_step(scratch / "few.ciel", 101);
    EXPECT_EQ(stat_calls_of([&] { (void)reader->refreshed(); }), first);
}

// A process that keeps the file open and locked, as replace_file does, until this object is destroyed.
class LivingWriter {
public:
    explicit LivingWriter(const fs::path& file) {
        int ready[2], done[2];
        EXPECT_EQ(::pipe(ready) + ::pipe(done), 0);
        child_ = ::fork();
        if (child_ == 0) {
            ::close(done[1]);
            FILE* open = std::fopen(file.c_str(), "w");
            ::flock(fileno(open), LOCK_EX);
            char byte = 1;
            (void)!::write(ready[1], &byte, 1);
            (void)!::read(done[0], &byte, 1);
            ::_exit(0);
        }
        char byte = 0;
        EXPECT_EQ(::read(ready[0], &byte, 1), 1);
        for (const int fd : {ready[0], ready[1], done[0]}) ::close(fd);
        done_ = done[1];
    }
    ~LivingWriter() {
        ::close(done_);
        ::waitpid(child_, nullptr, 0);
    }
    LivingWriter(const LivingWriter&) = delete;

private:
    pid_t child_ = 0;
    int done_ = -1;
};

TEST(AppendFiles, WhatKilledOnesHaveLeftIsRemovedButNothingOfALivingOne) {
    const test::Folder scratch;
    const fs::path directory = scratch / "a.ciel", mesh = directory / "meshes/0";
    write_steps(directory, 2);
    const std::vector<fs::path> left{directory / "steps.json.new-4194300", mesh / ".zattrs.new-7",
                                     mesh / "arrays/p/2.0.new-4194300", mesh / "positions/1.0.0.new-12",
                                     mesh / ("arrays/q/.zarray.new-" + std::to_string(::getpid()))};
    for (const fs::path& file : left) test::overwrite_file(file, "half");
    const std::vector<fs::path> not_ours{directory / "steps.json.new", mesh / "arrays/p/notes.new-a",
                                         mesh / "arrays/p/.new-"};
    for (const fs::path& file : not_ours) test::overwrite_file(file, "a user's");
    const fs::path living = mesh / "arrays/p/3.0.new-4194299";
    const LivingWriter writer(living);
    append_step(directory, 5);
    for (const fs::path& file : left) EXPECT_FALSE(fs::exists(file)) << file;
    for (const fs::path& file : not_ours) EXPECT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(fs::exists(living)) << "somebody writes it";
    EXPECT_EQ(Dataset::open(directory)->steps().size(), 3U);
}

TEST(AppendFiles, WhoDoesNotGetTheLockRemovesNothing) {
    const test::Folder scratch;
    const fs::path directory = scratch / "a.ciel", left = directory / "meshes/0/arrays/p/2.0.new-4194300";
    write_steps(directory, 2);
    const Writer first = Writer::append(directory);
    test::overwrite_file(left, "half");
    EXPECT_THROW((void)Writer::append(directory), Error);
    EXPECT_TRUE(fs::exists(left));
}

// A remover may find the file of a writer before the writer has locked it.
TEST(ReplaceFile, KeepsItsFileFromARemover) {
    const test::Folder folder;
    std::atomic<bool> ends = false;
    std::thread remover([&] {
        while (!ends) remove_left_beside(folder.path());
    });
    for (int i = 0; i < 300; ++i) EXPECT_NO_THROW(replace_file(folder / "file", bytes_of(std::to_string(i)))) << i;
    ends = true;
    remover.join();
    EXPECT_EQ(test::read_file(folder / "file"), "299");
}

} // namespace
} // namespace server::store
