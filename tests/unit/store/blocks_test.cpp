// Blocks on disk: the bytes read are those written, and they are the ones that the README shows.
#include "ciel/extract.hpp"
#include "store/cache/stored_blocks.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"
#include "store/format/value_ranges.hpp"
#include "store/loaded.hpp"
#include "store/mesh_arrays.hpp"
#include "store/write_blocks.hpp"
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

const std::string id = "0123456789abcdef";
constexpr std::array<double, 6> bounds{0, 1, 0, 1, 0, 1};

FaceMesh one_tetrahedron() {
    FaceMesh mesh;
    mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    mesh.cell_types = {static_cast<std::uint8_t>(CellType::tetrahedron)};
    mesh.face_offset = {0, 3, 6, 9, 12};
    mesh.face_vertex = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    mesh.owner = {0, 0, 0, 0};
    mesh.neighbour = {none, none, none, none};
    return mesh;
}

FaceMesh cells_of_all_kinds() { return assemble(test::view(test::zoo({{8, 8, 8}}))).mesh; }

const BlockSizes small_blocks{{32}};

void write_cells_of_all_kinds(const test::Folder& scratch) {
    const FaceMesh mesh = cells_of_all_kinds();
    write_blocks(scratch.path(), mesh.view(), id, bounds, small_blocks);
}

TEST(Blocks, HaveTheBytesThatTheReadmeShows) {
    const test::Folder scratch;
    const FaceMesh mesh = one_tetrahedron();
    write_blocks(scratch.path(), mesh.view(), id, bounds);
    std::string shown;
    for (const char* file : {"index", "cells/0", "around/0", "mates/0"})
        shown += std::string("blocks/") + file + '\n' + test::hex_dump(test::read_file(scratch / "blocks" / file));
    const std::string readme = test::read_file(fs::path(CIEL_SOURCE_DIR) / "server/store/README.md");
    EXPECT_THAT(readme, testing::HasSubstr("```\n" + shown + "```")) << "the README must show:\n" << shown;
}

TEST(Ranges, HaveTheBytesThatTheReadmeShows) {
    const FaceMesh mesh = one_tetrahedron();
    const Topology topology(mesh.view());
    const BlockBoxes boxes = block_boxes(topology, mesh.positions);
    const auto bytes = std::as_bytes(std::span(mesh.positions));
    const ValueRanges ranges{{boxes.begin(), boxes.end()}, {}, stretch_checksums(bytes)};
    const std::vector<std::byte> made = to_bytes(ranges, id, checksum_number(bytes));
    const std::string shown =
        "positions/ranges/0\n" + test::hex_dump({reinterpret_cast<const char*>(made.data()), made.size()});
    const std::string readme = test::read_file(fs::path(CIEL_SOURCE_DIR) / "server/store/README.md");
    EXPECT_THAT(readme, testing::HasSubstr("```\n" + shown + "```")) << "the README must show:\n" << shown;
}

// Expects the same bytes in all records of both topologies.
void expect_same_records(const Topology& a, const Topology& b) {
    EXPECT_EQ(a.tables(), b.tables());
    ASSERT_EQ(a.block_count(), b.block_count());
    for (Index block = 0; block < a.block_count(); ++block)
        for (const RecordKind kind : record_kinds)
            EXPECT_TRUE(std::ranges::equal(a.record(block, kind), b.record(block, kind)));
}

// Returns the bytes of mapped files, whose paths contain `part`, that this process has touched.
std::size_t touched_bytes(const fs::path& part) {
    std::ifstream mappings("/proc/self/smaps");
    std::size_t sum = 0;
    bool is_part = false;
    for (std::string line; std::getline(mappings, line);) {
        std::istringstream words(line);
        std::string first;
        std::size_t kilobytes = 0;
        words >> first;
        if (!first.ends_with(':')) is_part = line.find(part.string()) != std::string::npos;
        if (is_part && first == "Rss:" && words >> kilobytes) sum += kilobytes << 10U;
    }
    return sum;
}

class BlocksBy : public testing::TestWithParam<FileAccess> {
protected:
    const test::Folder scratch;
    [[nodiscard]] std::shared_ptr<const StoredBlocks> open() const {
        return std::make_shared<const StoredBlocks>(scratch.path(), id, no_losses(), GetParam());
    }
};

TEST_P(BlocksBy, AreReadAsTheyWereWritten) {
    const FaceMesh mesh = cells_of_all_kinds();
    const Topology built(mesh.view(), small_blocks.topology);
    ASSERT_GT(built.block_count(), 20U);
    const TopologyCounts counts = write_blocks(scratch.path(), mesh.view(), id, bounds, small_blocks);
    EXPECT_EQ(counts.half_edges, built.counts().half_edges);
    const Topology found = open()->topology();
    const std::size_t before = found.memory_bytes();
    EXPECT_LT(before, 10000U) << "no record is read before it is used";
    EXPECT_EQ(touched_bytes(scratch / "blocks"), 0U);
    expect_same_records(found, built);
    std::size_t all = 0;
    for (Index b = 0; b < built.block_count(); ++b)
        for (const RecordKind kind : record_kinds) all += built.record(b, kind).size();
    const std::size_t mapped = touched_bytes(scratch / "blocks");
    EXPECT_EQ(found.memory_bytes() - before, GetParam() == FileAccess::read ? all : 0);
    EXPECT_EQ(mapped >= all, GetParam() == FileAccess::mapped) << mapped;
}

TEST_P(BlocksBy, AFlippedBitIsFoundAtTheFirstUse) {
    write_cells_of_all_kinds(scratch);
    const fs::path file = layout::records(scratch.path(), RecordKind::cells, 0);
    std::string bytes = test::read_file(file);
    bytes[bytes.size() - 64] = static_cast<char>(bytes[bytes.size() - 64] ^ 1); // at most 63 bytes follow a record
    test::overwrite_file(file, bytes);
    const Topology found = open()->topology();
    EXPECT_NO_THROW((void)found.record(0, RecordKind::cells));
    for (int time = 0; time < 2; ++time) try {
            (void)found.record(found.block_count() - 1, RecordKind::cells);
            FAIL();
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("does not match the checksum of block"));
        }
}

TEST_P(BlocksBy, AFileThatShrinksIsLost) {
    write_cells_of_all_kinds(scratch);
    const auto blocks = open();
    const Topology found = blocks->topology();
    EXPECT_NO_THROW(blocks->check_unchanged());
    const fs::path file = layout::records(scratch.path(), RecordKind::cells, 0);
    fs::resize_file(file, 200);
    try {
        (void)found.record(found.block_count() - 1, RecordKind::cells);
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("while it was open"));
    }
    EXPECT_THROW(blocks->check_intact(), FileError);
}

INSTANTIATE_TEST_SUITE_P(Access, BlocksBy, testing::Values(FileAccess::mapped, FileAccess::read),
                         [](const auto& test) { return test.param == FileAccess::mapped ? "mapped" : "read"; });

// An index in a changed record may lead up to 1 MiB beyond a record's end, which must be readable (RecordSource).
TEST(Blocks, CanBeReadBeyondTheirEnd) {
    const test::Folder scratch;
    write_cells_of_all_kinds(scratch);
    const auto blocks = std::make_shared<const StoredBlocks>(scratch.path(), id, no_losses(), FileAccess::mapped);
    for (const RecordKind kind : record_kinds) {
        std::span<const std::byte> last; // in the file, whose order is not that of the blocks
        for (Index block = 0; block < blocks->block_count(); ++block)
            if (const auto record = blocks->mapped(block, kind); last.empty() || record.data() > last.data())
                last = record;
        for (std::size_t i = 0; i < std::size_t{1} << 20U; i += 512)
            EXPECT_EQ(*(last.data() + last.size() + i), std::byte{0});
    }
}

TEST(Blocks, OfAFolderHereAreMapped) {
    const test::Folder scratch;
    EXPECT_EQ(access_to(scratch.path()), FileAccess::mapped);
}

TEST(Blocks, FillFileAfterFile) {
    const test::Folder scratch;
    const FaceMesh mesh = cells_of_all_kinds();
    write_blocks(scratch.path(), mesh.view(), id, bounds, {small_blocks.topology, 4096});
    EXPECT_TRUE(fs::exists(layout::records(scratch.path(), RecordKind::cells, 2)));
    for (const auto& entry : fs::recursive_directory_iterator(scratch / "blocks/cells"))
        EXPECT_LE(entry.file_size(), 4096U);
    expect_same_records(std::make_shared<const StoredBlocks>(scratch.path(), id)->topology(),
                        Topology(mesh.view(), small_blocks.topology));
}

// A dataset of many blocks with the point array p and the vector U.
std::shared_ptr<Dataset> written(const test::Folder& scratch) {
    const Assembled made = assemble(test::view(test::zoo({{80, 10, 10}})));
    const std::size_t vertices = made.original_vertex.size();
    std::vector<float> p(vertices), u(3 * vertices);
    for (std::size_t v = 0; v < vertices; ++v) p[v] = made.mesh.positions[3 * v];
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = static_cast<float>(i % 7);
    p[5] = std::numeric_limits<float>::quiet_NaN();
    Writer writer(scratch / "a.ciel", {});
    writer.add_mesh(made.mesh, made.original_vertex, made.original_cell, {});
    writer.add_step(
        0, 0, 0,
        std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, p}, {{"U", Association::point, 3, "", ""}, u}});
    writer.finish();
    return Dataset::open(scratch / "a.ciel");
}

void expect_equal(const BlockRanges& a, const BlockRanges& b) {
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
    EXPECT_EQ(a.missing, b.missing);
}

TEST(Ranges, AreThoseOfTheBlocks) {
    const test::Folder scratch;
    const auto dataset = written(scratch);
    const Topology topology = dataset->topology(0);
    ASSERT_GT(topology.block_count(), 3U);
    for (const char* array : {"p", "U"}) {
        const ArrayInfo& info = *dataset->find(array);
        for (const ScalarName& scalar : scalars_of(info))
            expect_equal(dataset->block_ranges(scalar, 0).value(),
                         block_ranges(topology, one_scalar(info, dataset->values(array, 0), scalar)));
    }
    const auto boxes = dataset->block_boxes(0, 0).value(),
               expected = block_boxes(topology, dataset->mesh_arrays().points(0, 0).positions);
    for (std::size_t axis = 0; axis < 3; ++axis) expect_equal(boxes[axis], expected[axis]);
}

TEST(Ranges, AreWrittenForAppendedStepsToo) {
    const test::Folder scratch;
    const auto before = written(scratch);
    std::vector<float> positions(before->mesh_arrays().points(0, 0).positions.begin(),
                                 before->mesh_arrays().points(0, 0).positions.end());
    for (float& x : positions) x *= 2;
    std::vector<float> p(positions.size() / 3, 1);
    p[0] = -7;
    Writer writer = Writer::append(scratch / "a.ciel");
    const std::size_t moved = writer.add_coordinates(0, positions);
    writer.add_step(1, 0, moved, std::vector<ArrayValues>{{{"p", Association::point, 1, "", ""}, p}});
    writer.finish();
    const auto dataset = Dataset::open(scratch / "a.ciel");
    const Topology topology = dataset->topology(0);
    expect_equal(dataset->block_ranges({"p", std::nullopt, false}, 1).value(), block_ranges(topology, p));
    expect_equal(dataset->block_boxes(0, moved).value()[2], block_boxes(topology, positions)[2]);
}

TEST(Ranges, LetASurfaceReadTheBlocksThatItCrosses) {
    const test::Folder scratch;
    LoadedDataset loaded(written(scratch), 1U << 24);
    const ScalarField p = loaded.scalar("p", 0); // p equals x
    const auto [low, high] = p.field->range();
    const double near_one_side = low + 0.06 * (high - low);
    const double origin = loaded.dataset()->mesh_arrays().points_to_load(0, 0).origin[0];
    const ScalarField plane = loaded.plane(0, {origin + near_one_side, 0, 0}, {1, 0, 0});
    const fs::path cells = scratch / "a.ciel/meshes/0/blocks/cells";
    EXPECT_EQ(touched_bytes(scratch / "a.ciel/meshes/0/blocks"), 0U) << "a field reads no record";
    Query query = p.query();
    Surface surface;
    query.extract(near_one_side, false, surface);
    EXPECT_FALSE(surface.polygon_cell.empty());
    const std::size_t some = touched_bytes(cells);
    query.set_field(*plane.field);
    query.extract(0, false, surface);
    EXPECT_FALSE(surface.polygon_cell.empty());
    std::size_t all = 0;
    for (Index b = 0; b < p.topology->block_count(); ++b) all += p.topology->record(b, RecordKind::cells).size();
    EXPECT_GT(some, 0U);
    EXPECT_LT(some, all / 2);
}

TEST(Ranges, OfAChunkThatWasReplacedAreNotUsed) {
    const test::Folder scratch;
    const auto range = LoadedDataset(written(scratch), 0).scalar("p", 0).field->range();
    const fs::path folder = scratch / "a.ciel", chunk = folder / "meshes/0/arrays/p/0.0";
    std::string values = test::read_file(chunk), marker = test::read_file(folder / "steps.json");
    const std::string before = checksum(bytes_of(values));
    values[0] = static_cast<char>(values[0] ^ 1);
    test::overwrite_file(chunk, values);
    marker.replace(marker.find(before), before.size(), checksum(bytes_of(values)));
    test::overwrite_file(folder / "steps.json", marker);
    EXPECT_FALSE(Dataset::open(folder)->block_ranges({"p", std::nullopt, false}, 0));
    EXPECT_EQ(LoadedDataset(Dataset::open(folder), 0).scalar("p", 0).field->range()[1], range[1]);
}

} // namespace
} // namespace server::store
