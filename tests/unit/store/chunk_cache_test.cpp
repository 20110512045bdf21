// Datasets of many steps: only the most recently used chunks, and chunks that are in use, stay mapped.
#include "ciel/extract.hpp"
#include "store/cache/chunk_cache.hpp"
#include "store/loaded.hpp"
#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"
#include "support/meshes.hpp"
#include "support/store_box/box.hpp"
#include "support/views.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

constexpr std::size_t steps = 3 * ChunkCache::most_kept;

std::size_t mapped_files(const fs::path& part) {
    std::ifstream mappings("/proc/self/maps");
    std::size_t count = 0;
    for (std::string line; std::getline(mappings, line);)
        count += line.find(part.string()) != std::string::npos ? 1 : 0;
    return count;
}

// Each step has its own values and positions: p is the number of the step, and x is moved by it.
class ManySteps : public testing::Test {
protected:
    void SetUp() override {
        const Assembled made = assemble(test::view(test::hexahedra({{2, 2, 2}})));
        std::vector<float> positions = made.mesh.positions, p(positions.size() / 3);
        Writer writer(directory, {});
        const std::size_t mesh = writer.add_mesh(made.mesh, made.original_vertex, made.original_cell, {});
        for (std::size_t step = 0; step < steps; ++step) {
            std::ranges::fill(p, static_cast<float>(step));
            if (step > 0)
                for (std::size_t x = 0; x < positions.size(); x += 3) positions[x] += 1;
            const std::size_t moved = step == 0 ? 0 : writer.add_coordinates(mesh, positions);
            writer.add_step(static_cast<double>(step), mesh, moved,
                            std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, p}});
        }
        writer.finish();
    }

    test::Folder scratch;
    fs::path directory = scratch / "many.ciel";
};

TEST_F(ManySteps, OnlyTheLastUsedStayMapped) {
    const auto dataset = Dataset::open(directory);
    const fs::path chunks = directory / "meshes/0/arrays/p";
    for (std::size_t step = 0; step < steps; ++step)
        EXPECT_THAT(dataset->values("p", step), testing::Each(static_cast<float>(step)));
    EXPECT_EQ(mapped_files(chunks), ChunkCache::most_kept);
    EXPECT_THAT(dataset->values("p", 0), testing::Each(0.0F)) << "is mapped again";
    EXPECT_EQ(mapped_files(chunks), ChunkCache::most_kept);
    dataset->check_intact();
}

TEST_F(ManySteps, WhatSomebodyHoldsStaysMapped) {
    const auto dataset = Dataset::open(directory);
    const Values first = dataset->values("p", 0);
    const FaceMeshView points = dataset->mesh_arrays().points(0, 1);
    const float x = points.positions[0];
    for (std::size_t step = 1; step < steps; ++step) {
        (void)dataset->values("p", step);
        (void)dataset->mesh_arrays().points(0, step);
    }
    EXPECT_THAT(first, testing::Each(0.0F));
    EXPECT_EQ(dataset->values("p", 0).data(), first.data());
    EXPECT_EQ(dataset->mesh_arrays().points(0, 1).positions.data(), points.positions.data());
    EXPECT_EQ(points.positions[0], x);
}

TEST_F(ManySteps, AChunkThatChangedWhileItWasLetGoIsFound) {
    const auto dataset = Dataset::open(directory);
    for (std::size_t step = 0; step < steps; ++step) (void)dataset->values("p", step);
    const fs::path chunk = directory / "meshes/0/arrays/p/0.0";
    std::string bytes = test::read_file(chunk);
    bytes[0] = static_cast<char>(bytes[0] ^ 1);
    test::overwrite_file(chunk, bytes);
    EXPECT_THROW((void)dataset->values("p", 0), Error);
    EXPECT_THAT(dataset->values("p", 1), testing::Each(1.0F));
}

TEST_F(ManySteps, AFieldOfAnEarlierStepCanStillBeCut) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 20U);
    const ScalarField early = loaded.plane(1, {1.5, 0, 0}, {1, 0, 0});
    for (std::size_t step = 2; step < steps; ++step) (void)loaded.scalar("p", step);
    Query query = early.query();
    Surface surface;
    ASSERT_TRUE(query.extract(0, true, surface));
    EXPECT_EQ(surface.polygon_cell.size(), 4U);
}

TEST(MappedFile, NamesTheFirstLoss) {
    const test::Folder scratch;
    const std::filesystem::path path = scratch / "file";
    test::overwrite_file(path, std::string(8192, 'a'));
    const MappedFile file(path, 8192);
    std::filesystem::resize_file(path, 0);
    EXPECT_THROW(file.load(file.bytes()), ciel::Error);
    test::overwrite_file(path, std::string(8192, 'b')); // the same file, changed
    try {
        file.refuse();
    } catch (const ciel::Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("has shrunk"));
    }
}

} // namespace
} // namespace server::store
