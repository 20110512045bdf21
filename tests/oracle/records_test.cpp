// The records of blocks: the bytes depend on a block's cells only, and bytes that are damaged are refused.
#include "blocks/blocks.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <cstring>
#include <functional>
#include <gtest/gtest.h>

namespace ciel::test {
namespace {

// The mesh, and then a second one like it that has nothing in common with the first.
FaceMesh twice(const FaceMesh& mesh) {
    const auto vertices = static_cast<Index>(mesh.positions.size() / 3);
    const auto corners = mesh.face_offset.back();
    const auto cells = static_cast<Index>(mesh.cell_types.size());
    FaceMesh both = mesh;
    both.positions.insert(both.positions.end(), mesh.positions.begin(), mesh.positions.end());
    both.cell_types.insert(both.cell_types.end(), mesh.cell_types.begin(), mesh.cell_types.end());
    for (std::size_t f = 1; f < mesh.face_offset.size(); ++f) both.face_offset.push_back(corners + mesh.face_offset[f]);
    for (const Index v : mesh.face_vertex) both.face_vertex.push_back(vertices + v);
    for (const Index c : mesh.owner) both.owner.push_back(cells + c);
    for (const Index c : mesh.neighbour) both.neighbour.push_back(c == none ? none : cells + c);
    return both;
}

class Records : public testing::TestWithParam<NamedMesh> {};

TEST_P(Records, OfABlockAreTheSameWhereverItLies) {
    const Assembled assembled = assemble(view(GetParam().make()));
    const auto cells = static_cast<Index>(assembled.mesh.cell_types.size());
    if (cells == 0) return;
    Index blocks = 2; // no block may have cells of both copies
    while (blocks < cells && cells % blocks != 0) ++blocks;
    const Topology::Options options{cells / blocks};
    const Topology one(assembled.mesh.view(), options);
    const FaceMesh doubled = twice(assembled.mesh);
    const Topology both(doubled.view(), options);
    ASSERT_EQ(both.block_count(), 2 * one.block_count());
    for (Index b = 0; b < one.block_count(); ++b)
        for (const RecordKind kind : {RecordKind::cells, RecordKind::around, RecordKind::mates}) {
            const auto record = one.blocks().source->record(b, kind);
            EXPECT_TRUE(std::ranges::equal(record, both.blocks().source->record(b, kind)));
            EXPECT_TRUE(std::ranges::equal(record, both.blocks().source->record(one.block_count() + b, kind)));
        }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Records, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

RecordBytes small_record() {
    const std::vector<std::uint16_t> shorts{1, 2, 3};
    const std::vector<std::uint64_t> longs{4};
    RecordWriter writer;
    writer.add(7, std::span<const std::uint16_t>(shorts));
    writer.add(9, std::span<const std::uint64_t>(longs));
    return writer.finish(RecordKind::cells);
}

RecordView view_of(const RecordBytes& bytes, std::uint16_t largest_id = 20) {
    return {std::as_bytes(std::span(bytes)), RecordKind::cells, largest_id};
}

TEST(Record, HasTheBytesThatItsFormatSays) {
    const RecordBytes bytes = small_record();
    // Header; two sections of the table; (1, 2, 3) as 16 bits; 4 as 64 bits.
    const RecordBytes expected{0x0002'0001'6c6c'6563, 64,
                               0x0000'0002'0001'0007, 0x0000'0006'0000'0003,
                               0x0000'0008'0001'0009, 0x0000'0007'0000'0001,
                               0x0000'0003'0002'0001, 4};
    EXPECT_EQ(bytes, expected);
    const RecordView view = view_of(bytes);
    EXPECT_TRUE(std::ranges::equal(view.get<std::uint16_t>(7), std::vector<std::uint16_t>{1, 2, 3}));
    EXPECT_EQ(view.get<std::uint64_t>(9)[0], 4U);
    EXPECT_TRUE(view.get<std::uint8_t>(8).empty());
}

struct Damage {
    const char* name;
    std::function<void(RecordBytes&)> make;
    const char* sentence;
};

class DamagedRecord : public testing::TestWithParam<Damage> {};

TEST_P(DamagedRecord, IsRefusedInWords) {
    RecordBytes bytes = small_record();
    GetParam().make(bytes);
    try {
        (void)view_of(bytes).get<std::uint16_t>(7);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().sentence), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    , DamagedRecord,
    testing::Values(
        Damage{"Empty", [](RecordBytes& b) { b.clear(); }, "it has 0 bytes"},
        Damage{"Kind", [](RecordBytes& b) { b[0] ^= 1; }, "it is of another kind"},
        Damage{"Version", [](RecordBytes& b) { b[0] += std::uint64_t{1} << 32; }, "has the version 2"},
        Damage{"Truncated", [](RecordBytes& b) { b.pop_back(); }, "it is cut off"},
        Damage{"Longer", [](RecordBytes& b) { b.push_back(0); }, "it is cut off"},
        Damage{"TooManySections", [](RecordBytes& b) { b[0] += std::uint64_t{9} << 48; }, "it is cut off"},
        Damage{"Beyond", [](RecordBytes& b) { b[3] += 40; }, "section 7 goes beyond its end"},
        Damage{"OffsetBeyond", [](RecordBytes& b) { b[3] += std::uint64_t{9} << 32; }, "section 7 goes beyond its end"},
        Damage{"InTheTable", [](RecordBytes& b) { b[3] -= std::uint64_t{4} << 32; }, "section 7 goes beyond its end"},
        Damage{"NoElement", [](RecordBytes& b) { b[2] &= 0xffff'ffff; }, "section 7 goes beyond its end"},
        Damage{"Twice", [](RecordBytes& b) { b[4] = b[4] - 9 + 7; }, "section 7 is given twice"},
        Damage{"Unknown", [](RecordBytes& b) { b[4] += 90; }, "has the section 99, which this program does not know"},
        Damage{"ElementSize", [](RecordBytes& b) { b[2] -= std::uint64_t{1} << 32; },
               "an element of section 7 has 1 bytes"}),
    [](const auto& test) { return test.param.name; });

TEST(Record, AnUnknownSectionThatIsNotCriticalIsSkipped) {
    RecordBytes bytes = small_record();
    bytes[4] = (bytes[4] + 90) & ~std::uint64_t{0x1'0000};
    EXPECT_EQ(view_of(bytes).get<std::uint16_t>(7).size(), 3U);
}

} // namespace
} // namespace ciel::test
