// Records that are built one by one: the same bytes as those of a topology in memory, from faces and from matched
// cells.
#include "ciel/record_sink.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/copied_records.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

using Call = std::pair<Index, RecordKind>;

class Collected final : public RecordSink {
public:
    void put(Index block, RecordKind kind, std::vector<std::uint64_t> record) override {
        calls.emplace_back(block, kind);
        if (calls.size() == fail_at) throw Error("the disk is full");
        EXPECT_TRUE(records.emplace(Call{block, kind}, std::move(record)).second) << "a record came twice";
    }
    std::vector<Call> calls;
    std::map<Call, std::vector<std::uint64_t>> records;
    std::size_t fail_at = 0; // 0: never
};

MatchedCells matched_cells(const Polyhedra& input) {
    const auto owner = std::make_shared<const Polyhedra>(input);
    return {view(*owner), owner};
}

class BuildRecords : public testing::TestWithParam<NamedMesh> {};

TEST_P(BuildRecords, MakesTheRecordsOfATopology) {
    const Polyhedra input = GetParam().make();
    const Assembled assembled = assemble(view(input));
    const MatchedCells matched = matched_cells(input);
    for (const Index cells_per_block : {1U, 7U, 32U, 4096U}) {
        const CopiedRecords expected{Topology(assembled.mesh.view(), {cells_per_block})};
        Collected from_faces, from_cells;
        const BuiltRecords built = build_records(assembled.mesh.view(), from_faces, {cells_per_block});
        EXPECT_TRUE(built.tables == expected.tables) << cells_per_block;
        EXPECT_TRUE(from_faces.records == expected.records) << cells_per_block;
        const BuiltRecords from_matched = build_records(matched, from_cells, {cells_per_block});
        EXPECT_TRUE(from_matched.tables == expected.tables) << cells_per_block;
        EXPECT_TRUE(from_cells.records == expected.records) << cells_per_block;
        EXPECT_TRUE(from_cells.calls == from_faces.calls) << "the order depends on the mesh only";
        std::erase_if(from_faces.calls, [](const Call& call) { return call.second != RecordKind::cells; });
        EXPECT_TRUE(std::ranges::is_sorted(from_faces.calls));
    }
}

TEST(BuildRecordsOf, CellsWithoutAnOwnerAreRefused) {
    const Polyhedra input = all_meshes().front().make();
    EXPECT_THROW(MatchedCells(view(input), nullptr), Error);
}

TEST_P(BuildRecords, AgreesWithTheListOfFaces) {
    const Polyhedra input = GetParam().make();
    const Assembled assembled = assemble(view(input));
    const MatchedCells matched = matched_cells(input);
    const FaceMesh boundary = matched.boundary();
    const FaceLists expected = numbered_faces(assembled.mesh.view(), {});
    EXPECT_EQ(boundary.face_vertex, expected.face_vertex);
    EXPECT_EQ(boundary.face_offset, expected.face_offset);
    EXPECT_EQ(boundary.owner, expected.owner);
    EXPECT_EQ(boundary.neighbour, expected.neighbour);
    EXPECT_EQ(boundary.cell_types, assembled.mesh.cell_types);
    EXPECT_EQ(boundary.positions, assembled.mesh.positions);
    const Topology topology(assembled.mesh.view());
    for (Index cell = 0; cell < boundary.cell_types.size(); ++cell)
        EXPECT_EQ(matched.corners(cell), corners_of_cell(topology, cell));
    EXPECT_TRUE(std::ranges::equal(matched.original_cell(), assembled.original_cell));
    EXPECT_TRUE(std::ranges::equal(matched.original_vertex(), assembled.original_vertex));
}

INSTANTIATE_TEST_SUITE_P(Meshes, BuildRecords, testing::ValuesIn(all_meshes()),
                         [](const auto& test) { return test.param.name; });

TEST(BuildRecordsOf, AGiantCellAreTheSame) {
    const Polyhedra input = giant_cell(56);
    const Assembled assembled = assemble(view(input));
    for (const Index cells_per_block : {100U, 4096U}) {
        const CopiedRecords expected{Topology(assembled.mesh.view(), {cells_per_block})};
        Collected from_cells;
        (void)build_records(matched_cells(input), from_cells, {cells_per_block});
        EXPECT_TRUE(from_cells.records == expected.records) << cells_per_block;
    }
}

TEST(BuildRecordsOf, CellsWithoutFacesAreComplete) {
    FaceMesh mesh;
    mesh.positions = {0, 0, 0};
    mesh.cell_types = {static_cast<std::uint8_t>(CellType::polyhedron)};
    EXPECT_EQ(Topology(mesh.view()).counts().half_edges, 0U);
}

TEST(BuildRecordsInto, ASinkThatThrowsGetsNoFurtherCall) {
    const Assembled assembled = assemble(view(zoo({{8, 8, 8}})));
    Collected all;
    (void)build_records(assembled.mesh.view(), all, {16});
    for (const std::size_t fail_at : {std::size_t{1}, std::size_t{5}, all.calls.size()}) {
        Collected sink;
        sink.fail_at = fail_at;
        EXPECT_THROW((void)build_records(assembled.mesh.view(), sink, {16}), Error);
        EXPECT_EQ(sink.calls.size(), fail_at);
    }
}

} // namespace
} // namespace ciel::test
