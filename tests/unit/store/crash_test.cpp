// A writer that fails or is killed leaves no partial dataset.
#include "store/mesh_arrays.hpp"
#include "store/new_dataset_directory.hpp"
#include "support/store_box/box.hpp"

#include <csignal>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

std::vector<std::string> entries(const fs::path& directory) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) names.push_back(entry.path().filename().string());
    return names;
}

// Runs `body` in a child process and returns its wait status.
template <typename Body>
int in_child(const Body& body) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            body();
        } catch (...) { // without _exit the child would run the remaining tests
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

void add_box(Writer& writer, const FaceMesh& mesh) {
    writer.add_mesh(mesh, test::identity(mesh.positions.size() / 3), test::identity(mesh.cell_types.size()), {});
}

TEST(Crash, AnExceptionOrNoFinishLeavesNothing) {
    const test::Folder scratch;
    {
        Writer writer(scratch / "a.ciel", {});
        add_box(writer, test::box(2, 2, 2));
        const std::vector<float> wrong(3);
        EXPECT_THROW(writer.add_step(0, 0, 0, std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, wrong}}),
                     Error);
    }
    EXPECT_THAT(entries(scratch.path()), testing::IsEmpty());
}

TEST(Crash, AKilledWriterLeavesNoDatasetAndTheNextOneCleansUp) {
    const test::Folder scratch;
    const int status = in_child([&] {
        Writer writer(scratch / "a.ciel", {});
        add_box(writer, test::box(2, 2, 2));
        ::kill(::getpid(), SIGKILL);
    });
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_FALSE(fs::exists(scratch / "a.ciel"));
    EXPECT_EQ(entries(scratch.path()).size(), 1U);
    test::write_box(scratch / "a.ciel", test::box(2, 2, 2));
    EXPECT_THAT(entries(scratch.path()), testing::ElementsAre("a.ciel"));
}

TEST(Crash, AWriterAtWorkIsNotCleanedUpByAnother) {
    const test::Folder scratch;
    Writer first(scratch / "a.ciel", {});
    add_box(first, test::box(1, 1, 1));
    Writer second(scratch / "a.ciel", {});
    add_box(second, test::box(2, 1, 1));
    first.finish();
    EXPECT_THROW(second.finish(), Error) << "the path is taken by now";
    EXPECT_EQ(Dataset::open(scratch / "a.ciel")->info().meshes[0].cells, 1U);
}

TEST(Crash, AFullDiskLeavesNothing) {
    const test::Folder scratch;
    const int status = in_child([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{2048, 2048};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            Writer writer(scratch / "a.ciel", {});
            add_box(writer, test::box(5, 5, 5));
        } catch (const Error&) {
            ::_exit(7);
        }
    });
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_THAT(entries(scratch.path()), testing::IsEmpty());
}

TEST(Crash, TheCommitMarkerIsWrittenAfterAllThatItNames) {
    const test::Folder scratch;
    test::write_box(scratch / "a.ciel", test::box(2, 2, 2));
    const auto dataset = Dataset::open(scratch / "a.ciel");
    Writer writer = Writer::append(scratch / "a.ciel");
    const fs::path attributes = scratch / "a.ciel/meshes/0/.zattrs", kept = scratch / "kept";
    fs::rename(attributes, kept);
    fs::create_directory(attributes);
    const auto q = test::values_of(27, 3);
    EXPECT_THROW(
        writer.add_step(5, 0, 0, std::vector<ArrayValues>{{{"q", Association::point, 1, "", "a new array"}, q}}),
        Error);
    fs::remove(attributes);
    fs::rename(kept, attributes);
    EXPECT_EQ(dataset->refreshed(), nullptr) << "a step whose mesh's document could not be written";
}

TEST(Crash, AnAppendThatFailsOrIsKilledLeavesTheDatasetAsItWas) {
    const test::Folder scratch;
    const FaceMesh mesh = test::box(9, 9, 9);
    test::write_box(scratch / "a.ciel", mesh);
    const auto dataset = Dataset::open(scratch / "a.ciel");
    const auto p = test::values_of(1000, 3);
    const std::vector<ArrayValues> step{{{"p", Association::point, 1, "Pa", ""}, p}};
    const int full = in_child([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        Writer writer = Writer::append(scratch / "a.ciel");
        const rlimit limit{3000, 3000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            writer.add_step(5, 0, 0, step);
        } catch (const Error&) {
            ::_exit(7);
        }
    });
    EXPECT_EQ(WEXITSTATUS(full), 7);
    EXPECT_EQ(dataset->refreshed(), nullptr);
    const int killed = in_child([&] {
        Writer writer = Writer::append(scratch / "a.ciel");
        (void)writer.add_coordinates(0, mesh.positions);
        ::kill(::getpid(), SIGKILL);
    });
    ASSERT_TRUE(WIFSIGNALED(killed));
    EXPECT_EQ(dataset->refreshed(), nullptr);
    EXPECT_EQ(Dataset::open(scratch / "a.ciel")->steps().size(), 3U);
    Writer::append(scratch / "a.ciel").add_step(5, 0, 0, step); // the killed process has lost its lock
    EXPECT_THAT(dataset->refreshed()->values("p", 3), testing::ElementsAreArray(p));
}

TEST(Overwrite, OnlyADatasetAndOnlyWhenAsked) {
    const test::Folder scratch;
    test::write_box(scratch / "a.ciel", test::box(1, 1, 1));
    EXPECT_THROW(Writer(scratch / "a.ciel", {}), Error);
    const auto before = Dataset::open(scratch / "a.ciel");
    (void)before->mesh_arrays().all_faces(0, 0);
    {
        Writer writer(scratch / "a.ciel", {}, true);
        add_box(writer, test::box(2, 1, 1));
        EXPECT_EQ(Dataset::open(scratch / "a.ciel")->info().meshes[0].cells, 1U) << "the old one stands until the end";
        writer.finish();
    }
    EXPECT_EQ(Dataset::open(scratch / "a.ciel")->info().meshes[0].cells, 2U);
    EXPECT_EQ(before->mesh_arrays().all_faces(0, 0).cell_count(), 1U) << "what was read stays";
    EXPECT_THAT(entries(scratch.path()), testing::ElementsAre("a.ciel"));
    fs::create_directory(scratch / "photos");
    test::overwrite_file(scratch / "photos" / "cat.jpg", "cat");
    EXPECT_THROW(Writer(scratch / "photos", {}, true), Error) << "never somebody's other directory";
    test::overwrite_file(scratch / "file", "text");
    EXPECT_THROW(Writer(scratch / "file", {}, true), Error);
    EXPECT_EQ(test::read_file(scratch / "photos" / "cat.jpg"), "cat");
    EXPECT_THROW(Writer(scratch / "nowhere/a.ciel", {}), Error) << "no folder";
    EXPECT_THAT(entries(scratch.path()), testing::UnorderedElementsAre("a.ciel", "file", "photos"));
}

TEST(Overwrite, APlaceIsCheckedWithoutATrace) {
    const test::Folder scratch;
    test::write_box(scratch / "a.ciel", test::box(1, 1, 1));
    check_new_dataset_directory(scratch / "a.ciel", true);
    check_new_dataset_directory(scratch / "b.ciel", false);
    EXPECT_THROW(check_new_dataset_directory(scratch / "a.ciel", false), Error);
    EXPECT_THROW(check_new_dataset_directory(scratch / "nowhere/a.ciel", true), Error);
    EXPECT_THAT(entries(scratch.path()), testing::ElementsAre("a.ciel"));
}

void write_without_steps(const fs::path& directory) {
    Writer writer(directory, {});
    add_box(writer, test::box(1, 1, 1));
    writer.finish();
}

// Appends steps of two arrays until the process ends. Writes a byte to `told` after each.
[[noreturn]] void append_forever(const fs::path& directory, int told) {
    for (;;) {
        Writer writer = Writer::append(directory);
        const std::size_t step = writer.before()->steps().size();
        const auto p = test::values_of(8, step), q = test::values_of(8, 2 * step);
        writer.add_step(static_cast<double>(step), 0, 0,
                        std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p},
                                                 {{"q", Association::point, 1, "", ""}, q}});
        if (::write(told, "s", 1) != 1) ::_exit(1);
    }
}

// While the writer appends, steps are moved from the commit marker to the table several times.
TEST(Crash, AWriterKilledAtAnyMomentLosesNoStepThatItHasTold) {
    const test::Folder scratch;
    const fs::path directory = scratch / "a.ciel";
    write_without_steps(directory);
    std::mt19937 random(3);
    auto reader = Dataset::open(directory);
    std::size_t told = 0;
    for (int round = 0; round < 40 || told < 200; ++round) {
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) append_forever(directory, ends[1]);
        ::close(ends[1]);
        char byte = 0;
        const std::size_t wanted = 1 + random() % 12;
        for (std::size_t i = 0; i < wanted && ::read(ends[0], &byte, 1) == 1; ++i) ++told;
        ::usleep(random() % 3000);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        while (::read(ends[0], &byte, 1) == 1) ++told;
        ::close(ends[0]);
        if (auto now = reader->refreshed()) reader = std::move(now);
        const auto dataset = Dataset::open(directory);
        ASSERT_GE(dataset->steps().size(), told);
        ASSERT_LE(dataset->steps().size(), told + static_cast<std::size_t>(round) + 1);
        ASSERT_EQ(reader->steps().size(), dataset->steps().size());
        for (std::size_t step = 0; step < dataset->steps().size(); ++step) {
            ASSERT_EQ(dataset->steps()[step].time, static_cast<double>(step));
            ASSERT_THAT(dataset->values("p", step), testing::ElementsAreArray(test::values_of(8, step)));
        }
    }
    reader->verify();
}

TEST(Crash, AReaderSeesEachStepWhileTheyMoveToTheTable) {
    const test::Folder scratch;
    const fs::path directory = scratch / "a.ciel";
    write_without_steps(directory);
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) append_forever(directory, ends[1]);
    auto reader = Dataset::open(directory);
    while (reader->steps().size() < 150) {
        auto now = reader->refreshed();
        const auto opened = Dataset::open(directory);
        EXPECT_GE(opened->steps().size(), now ? now->steps().size() : 0);
        if (!now) continue;
        reader = std::move(now);
        const std::size_t last = reader->steps().size() - 1;
        ASSERT_THAT(reader->values("q", last), testing::ElementsAreArray(test::values_of(8, 2 * last)));
        ASSERT_EQ(reader->steps()[last / 2].time, static_cast<double>(last / 2));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ends[0]);
    ::close(ends[1]);
}

} // namespace
} // namespace server::store
