// Catalog::watch tells of datasets that other processes append to, replace or damage, and goes on after any error.
#include "store/catalog.hpp"
#include "store/mesh_arrays.hpp"
#include "support/store_box/box.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

class CatalogWatch : public testing::Test {
protected:
    CatalogWatch() { test::write_box(directory, test::box(2, 2, 2)); }

    const test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
};

// Calls of on_change that other threads wait for.
class Heard {
public:
    void add(const std::string& name) {
        const std::lock_guard lock(mutex_);
        names_.push_back(name);
        changed_.notify_all();
    }
    bool wait_for(std::size_t count) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, std::chrono::seconds(60), [&] { return names_.size() >= count; });
    }
    std::vector<std::string> names() {
        const std::lock_guard lock(mutex_);
        return names_;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::string> names_;
};

TEST_F(CatalogWatch, TellsOfStepsAndOfAReplacement) {
    Catalog catalog({directory});
    const auto loaded = catalog.open("box");
    Heard heard;
    const auto handle = catalog.watch([&](const std::string& name) { heard.add(name); });
    const auto p = test::values_of(27, 5);
    Writer::append(directory).add_step(2, 0, 0, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
    ASSERT_TRUE(heard.wait_for(1));
    EXPECT_EQ(loaded->dataset()->steps().size(), 4U);
    {
        Writer writer(directory, {}, true);
        writer.add_mesh(test::box(3, 1, 1), test::identity(16), test::identity(3), {});
        writer.finish();
    }
    ASSERT_TRUE(heard.wait_for(2));
    EXPECT_EQ(loaded->dataset()->info().meshes[0].cells, 8U) << "who has the old one open keeps it";
    EXPECT_EQ(catalog.open("box")->dataset()->info().meshes[0].cells, 3U);
    EXPECT_THAT(heard.names(), testing::ElementsAre("box", "box"));
}

TEST_F(CatalogWatch, GoesOnAndTellsAgainAfterAnException) {
    Catalog catalog({directory});
    (void)catalog.open("box");
    Heard heard;
    std::atomic<int> calls{0};
    const auto handle = catalog.watch([&](const std::string& name) {
        heard.add(name);
        if (++calls == 1) throw std::bad_alloc();
    });
    const auto p = test::values_of(27, 5);
    Writer::append(directory).add_step(2, 0, 0, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
    EXPECT_TRUE(heard.wait_for(2)) << "the call that failed is made again";
}

TEST_F(CatalogWatch, SurvivesAChangedFileWithoutAChecksum) {
    const fs::path attributes = directory / "meshes/0/.zattrs", types = directory / "meshes/0/cell_types/0";
    nlohmann::json document = nlohmann::json::parse(test::read_file(attributes));
    document["ciel"]["checksums"].erase("cell_types");
    test::overwrite_file(attributes, document.dump());
    Catalog catalog({directory});
    (void)catalog.open("box")->dataset()->mesh_arrays().points(0, 0); // maps the file
    Heard heard;
    const auto handle = catalog.watch([&](const std::string& name) { heard.add(name); });
    fs::last_write_time(types, fs::last_write_time(types) + std::chrono::seconds(5));
    EXPECT_TRUE(heard.wait_for(1));
}

TEST_F(CatalogWatch, SurvivesAFolderThatCannotBeSearched) {
    const fs::path cells = directory / "meshes/0/blocks/cells";
    Catalog catalog({directory});
    const auto loaded = catalog.open("box");
    (void)loaded->topology(0);
    const auto p = test::values_of(27, 5);
    Writer::append(directory).add_step(2, 0, 0, std::vector<ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p}});
    fs::remove_all(cells);
    fs::create_symlink(cells, cells); // each access fails with ELOOP, also for root
    Heard heard;
    const auto handle = catalog.watch([&](const std::string& name) { heard.add(name); });
    EXPECT_TRUE(heard.wait_for(1));
    EXPECT_EQ(loaded->dataset()->steps().size(), 4U);
}

} // namespace
} // namespace server::store
