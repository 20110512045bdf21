// A dataset is opened while a file of its topology is damaged. Then the file is restored by a rename, as a correct
// writer does.
#include "damage/damaged_file.hpp"
#include "store/dataset.hpp"
#include "support/store_box/box.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RestoredFiles : public testing::TestWithParam<const char*> {
protected:
    RestoredFiles() { test::write_box(directory, test::box(2, 2, 2)); }

    test::Folder scratch;
    fs::path directory = scratch / "box.ciel";
    fs::path file = directory / "meshes/0" / GetParam();
};

std::string loss_of(const Dataset& dataset) {
    try {
        dataset.check_unchanged();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

// The open dataset maps the damaged file and has not checked it yet. It must report the change, because only a dataset
// that is opened again maps the restored file.
TEST_P(RestoredFiles, AreNoticedBeforeTheyAreUsed) {
    const std::string content = test::read_file(file);
    std::string damaged = content;
    damaged[file.string().find("blocks") == std::string::npos ? 0 : 0x60] ^= 1;
    test::overwrite_file(file, damaged);
    const auto open = Dataset::open(directory);
    EXPECT_EQ(loss_of(*open), "");
    test::replace(file, content);
    EXPECT_THAT(loss_of(*open), HasSubstr(file.string() + ": has changed while it was open"));
    const auto again = Dataset::open(directory);
    EXPECT_EQ(loss_of(*again), "");
    EXPECT_NO_THROW(again->verify());
}

TEST_P(RestoredFiles, AreNoLossIfTheyAreReplacedByEqualOnes) {
    const auto open = Dataset::open(directory);
    test::replace(file, test::read_file(file));
    EXPECT_EQ(loss_of(*open), "");
    fs::remove(file);
    EXPECT_EQ(loss_of(*open), "");
    EXPECT_NO_THROW(open->verify());
}

INSTANTIATE_TEST_SUITE_P(arrays, RestoredFiles,
                         testing::Values("original_vertex/0", "faces/owner/0", "groups/0/0", "blocks/cells/0",
                                         "blocks/around/0", "blocks/mates/0"),
                         [](const auto& row) {
                             std::string name = row.param;
                             std::replace(name.begin(), name.end(), '/', '_');
                             return name;
                         });

// The group of cells is {0}, stored as zeros. Zeros are also read beyond the end of a truncated file, so the checksum
// matches. The truncation must be reported all the same.
TEST(TruncatedFiles, AreLostThoughTheirZerosHaveTheChecksum) {
    const test::Folder scratch;
    const fs::path directory = scratch / "box.ciel", file = directory / "meshes/0/groups/1/0";
    test::write_box(directory, test::box(2, 2, 2));
    const auto open = Dataset::open(directory);
    const std::string content = test::read_file(file);
    ASSERT_EQ(content, std::string(4, '\0'));
    fs::resize_file(file, 0);
    test::replace(file, content);
    EXPECT_THAT(loss_of(*open), HasSubstr("groups/1/0: has shrunk while it was open"));
}

} // namespace
} // namespace server::store
