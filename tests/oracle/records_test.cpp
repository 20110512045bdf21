// The records of blocks: their bytes depend only on the block's cells, and damaged bytes are refused.
#include "blocks/record.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/copied_records.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace ciel::test {

using namespace ciel::detail;

namespace {

// Returns the mesh followed by a copy of it that shares no vertex with the first.
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
            const auto record = one.record(b, kind);
            EXPECT_TRUE(std::ranges::equal(record, both.record(b, kind)));
            EXPECT_TRUE(std::ranges::equal(record, both.record(one.block_count() + b, kind)));
        }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Records, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

void expect_the_same_in_another_place(const KernelMesh& mesh) {
    const std::vector<float> values = random_field(mesh.topology.counts().vertices, 11);
    const Topology copy = read_back(std::make_unique<CopiedRecords>(mesh.topology));
    EXPECT_EQ(all_operators(copy), all_operators(mesh.topology));
    EXPECT_EQ(
        bit_difference(cut_in_all_ways(copy, mesh.mesh(), values), cut_in_all_ways(mesh.topology, mesh.mesh(), values)),
        "");
    EXPECT_EQ(copy.tables(), mesh.topology.tables());
}

TEST_P(Records, MakeTheSameTopologyInAnotherPlace) {
    expect_the_same_in_another_place(KernelMesh(GetParam().make(), {32}));
}

TEST(RecordsOfCollapsedCells, AreReadAgain) {
    Polyhedra input = hexahedra({{2, 1, 1}});
    for (std::size_t corner = input.face_offset[input.cell_offset[1]]; corner < input.face_vertex.size(); ++corner)
        input.face_vertex[corner] = 3; // the second cell is a point
    const KernelMesh mesh(input);
    ASSERT_EQ(mesh.topology.counts().cells, 2U);
    expect_the_same_in_another_place(mesh);
}

// Gives the sections with the parts of corners an unknown id, so that readers skip them. Records of earlier versions
// have no such sections. Returns the number of sections.
std::size_t hide_corner_parts(CopiedRecords& copied) {
    constexpr std::uint32_t corner_parts = 38, unknown = 999; // ids; the flags in the upper bits are 0
    std::size_t hidden = 0;
    for (auto& [place, record] : copied.records) {
        if (place.second != RecordKind::cells) continue;
        const std::size_t sections = record[0] >> 48;
        for (std::size_t s = 0; s < sections; ++s) {
            std::uint64_t& entry = record[2 + 2 * s];
            if ((entry & 0xffff'ffff) != corner_parts) continue;
            entry = (entry & ~std::uint64_t{0xffff'ffff}) | unknown;
            ++hidden;
        }
    }
    return hidden;
}

TEST_P(Records, OfEarlierVersionsGiveTheSameSurfaces) {
    const KernelMesh mesh(GetParam().make(), {32});
    const std::vector<float> values = random_field(mesh.topology.counts().vertices, 11);
    auto copied = std::make_unique<CopiedRecords>(mesh.topology);
    const std::size_t hidden = hide_corner_parts(*copied);
    const auto& types = mesh.mesh().cell_types;
    EXPECT_TRUE(hidden > 0 || std::ranges::count(types, static_cast<std::uint8_t>(CellType::polyhedron)) == 0);
    const Topology copy = read_back(std::move(copied));
    EXPECT_EQ(
        bit_difference(cut_in_all_ways(copy, mesh.mesh(), values), cut_in_all_ways(mesh.topology, mesh.mesh(), values)),
        "");
}

TEST_P(Records, AreReadWhenABlockIsTouchedOnly) {
    const KernelMesh mesh(GetParam().make(), {32});
    auto copied = std::make_unique<CopiedRecords>(mesh.topology);
    const CopiedRecords& source = *copied;
    const Topology copy = read_back(std::move(copied));
    EXPECT_EQ(source.reads, 0);
    if (copy.counts().cells == 0) return;
    (void)copy.half_edges(0);
    EXPECT_EQ(source.reads, 1);
}

// Changes some bytes of one record, or of the tables.
void damage(CopiedRecords& copied, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    RecordBytes* record = &copied.tables;
    if (below(8) != 0 && !copied.records.empty()) {
        auto chosen = copied.records.begin();
        std::advance(chosen, below(copied.records.size()));
        record = &chosen->second;
    }
    auto* bytes = reinterpret_cast<std::uint8_t*>(record->data());
    const std::size_t size = record->size() * sizeof((*record)[0]);
    for (std::size_t i = 0; i <= below(4); ++i) {
        std::uint8_t& byte = bytes[below(size)];
        byte = below(2) == 0 ? static_cast<std::uint8_t>(byte ^ 1U << below(8)) : bytes[below(size)];
    }
}

// Damaged records without a checksum: each use ends and stays inside the arrays, which builds with sanitizers check.
// The fuzz target `records` tries more of them.
TEST_P(Records, ThatAreDamagedAreRefusedOrHarmless) {
    const KernelMesh mesh(GetParam().make(), {32});
    if (mesh.topology.counts().cells == 0) return;
    const std::vector<float> values = random_field(mesh.topology.counts().vertices, 11);
    std::mt19937 random(7);
    for (int i = 0; i < 60; ++i) {
        auto copied = std::make_unique<CopiedRecords>(mesh.topology);
        damage(*copied, random);
        try {
            const Topology copy = read_back(std::move(copied));
            if (copy.counts().vertices != mesh.topology.counts().vertices) continue;
            (void)all_operators(copy);
            (void)cut_in_all_ways(copy, mesh.mesh(), values);
            (void)vertex_gradients(copy, mesh.mesh(), values);
            probe_some(copy, mesh.mesh());
            threshold_some(copy, mesh.mesh(), values);
        } catch (const Error& error) {
            EXPECT_TRUE(says_what_to_do(error.what())) << error.what();
        }
    }
}

RecordBytes small_record() {
    const std::vector<std::uint16_t> shorts{1, 2, 3};
    const std::vector<std::uint64_t> longs{4};
    RecordWriter writer;
    writer.add(7, std::span<const std::uint16_t>(shorts));
    writer.add(9, std::span<const std::uint64_t>(longs));
    return writer.finish(RecordKind::cells);
}

RecordView view_of(const RecordBytes& bytes) { return {std::as_bytes(std::span(bytes)), RecordKind::cells}; }

// Reads a record like a program that knows only the sections 7 and 9. Returns section 7.
std::span<const std::uint16_t> read_known(const RecordView& view) {
    const auto shorts = view.get<std::uint16_t>(7);
    (void)view.get<std::uint64_t>(9);
    view.check_all_known();
    return shorts;
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
        (void)read_known(view_of(bytes));
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
        Damage{"Truncated", [](RecordBytes& b) { b.pop_back(); }, "its length does not match its header"},
        Damage{"Longer", [](RecordBytes& b) { b.push_back(0); }, "its length does not match its header"},
        Damage{"TooManySections", [](RecordBytes& b) { b[0] += std::uint64_t{9} << 48; },
               "its length does not match its header"},
        Damage{"Beyond", [](RecordBytes& b) { b[3] += 40; }, "section 7 goes beyond the end of the record"},
        Damage{"OffsetBeyond", [](RecordBytes& b) { b[3] += std::uint64_t{9} << 32; },
               "section 7 goes beyond the end of the record"},
        Damage{"InTheTable", [](RecordBytes& b) { b[3] -= std::uint64_t{4} << 32; },
               "section 7 goes beyond the end of the record"},
        Damage{"NoElement", [](RecordBytes& b) { b[2] &= 0xffff'ffff; }, "section 7 goes beyond the end of the record"},
        Damage{"Twice", [](RecordBytes& b) { b[4] = b[4] - 9 + 7; }, "section 7 is given twice"},
        Damage{"UnknownBetweenKnownOnes", [](RecordBytes& b) { b[4] -= 1; },
               "has the section 8, which this program does not know"},
        Damage{"Unknown", [](RecordBytes& b) { b[4] += 90; }, "has the section 99, which this program does not know"},
        Damage{"ElementSize", [](RecordBytes& b) { b[2] -= std::uint64_t{1} << 32; },
               "an element of section 7 has a wrong size of 1 bytes"}),
    [](const auto& test) { return test.param.name; });

TEST(Record, AnUnknownSectionThatIsNotCriticalIsSkipped) {
    RecordBytes bytes = small_record();
    bytes[4] = (bytes[4] + 90) & ~std::uint64_t{0x1'0000};
    EXPECT_EQ(read_known(view_of(bytes)).size(), 3U);
}

} // namespace
} // namespace ciel::test
