// Data read equals data written: topology, groups, values, missing values, moved meshes, remeshing, appended steps.
#include "ciel/mesh_faces.hpp"
#include "store/mesh_arrays.hpp"
#include "store/no_value.hpp"
#include "support/store_box/box.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace server::store {
using namespace ciel;
namespace {

using test::box;
using test::Folder;
using test::identity;
using test::values_of;
using testing::ElementsAre;
using testing::ElementsAreArray;

std::shared_ptr<Dataset> written_box(const Folder& scratch, const FaceMesh& mesh) {
    test::write_box(scratch / "box.ciel", mesh);
    return Dataset::open(scratch / "box.ciel");
}

TEST(RoundTrip, TopologyIsTheSame) {
    const Folder scratch;
    const FaceMesh mesh = box(3, 2, 2);
    const auto dataset = written_box(scratch, mesh);
    const FaceMeshView view = dataset->mesh_arrays().all_faces(0, 0);
    EXPECT_THAT(view.positions, ElementsAreArray(mesh.positions));
    EXPECT_THAT(view.cell_types, ElementsAreArray(mesh.cell_types));
    EXPECT_TRUE(same_cells(dataset->topology(0), Topology(mesh.view())));
    EXPECT_EQ(view.face_count(), mesh.owner.size());
    EXPECT_THAT(dataset->original_cell(0), ElementsAreArray(identity(12)));
    EXPECT_THAT(dataset->original_vertex(0), ElementsAreArray(identity(36)));
}

TEST(RoundTrip, WhatCannotBeReadAgainIsRefusedUnderTheNameThatItWasToHave) {
    const Folder scratch;
    FaceMesh mesh = box(1, 1, 1);
    mesh.face_vertex.insert(mesh.face_vertex.end(), {0, 1}); // a face of two vertices, which assemble() would drop
    mesh.face_offset.push_back(mesh.face_vertex.size());
    mesh.owner.push_back(0);
    mesh.neighbour.push_back(none);
    try {
        test::write_box(scratch / "box.ciel", mesh);
        ADD_FAILURE() << "it was written";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr((scratch / "box.ciel/meshes/0/faces/face_offset").string()));
        EXPECT_THAT(error.what(), testing::HasSubstr("cannot be read back and was removed"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

TEST(RoundTrip, InfoCountsTheMesh) {
    const Folder scratch;
    const auto dataset = written_box(scratch, box(3, 2, 2));
    const DatasetInfo& info = dataset->info();
    EXPECT_EQ(info.name, "box");
    EXPECT_EQ(info.source, "box.vtu");
    EXPECT_EQ(info.length_units, "m");
    EXPECT_THAT(info.notes, ElementsAre("a note"));
    EXPECT_EQ(info.input_vertices, 36U);
    const MeshInfo& mesh = info.meshes.at(0);
    // Counts of a 3 x 2 x 2 box: 3*3*3 + 4*2*3 + 4*3*2 edges, 4*4 + 3*3*2 + 3*2*3 faces, 2 (6 + 6 + 4) boundary faces.
    EXPECT_EQ(mesh.vertices, 36U);
    EXPECT_EQ(mesh.edges, 75U);
    EXPECT_EQ(mesh.faces, 52U);
    EXPECT_EQ(mesh.boundary_faces, 32U);
    EXPECT_EQ(mesh.half_edges, 12U * 24U);
    EXPECT_EQ(mesh.components, 1U);
    EXPECT_EQ(mesh.cells_by_type.at("hexahedron"), 12U);
    EXPECT_THAT(mesh.bounds, ElementsAre(0, 3, 0, 2, 0, 2));
}

TEST(RoundTrip, TwoBoxesApartAreTwoComponents) {
    const Folder scratch;
    FaceMesh mesh = box(2, 1, 1), other = box(1, 1, 1);
    const auto vertices = static_cast<Index>(mesh.positions.size() / 3);
    for (const float x : other.positions) mesh.positions.push_back(x + 10);
    for (const Index v : other.face_vertex) mesh.face_vertex.push_back(v + vertices);
    for (std::size_t face = 0; face < other.owner.size(); ++face) {
        mesh.face_offset.push_back(mesh.face_offset.back() + 4);
        mesh.owner.push_back(2);
        mesh.neighbour.push_back(none);
    }
    mesh.cell_types.push_back(12);
    EXPECT_EQ(written_box(scratch, mesh)->info().meshes[0].components, 2U);
}

TEST(RoundTrip, GroupsKeepAnyNameAndAreSorted) {
    const Folder scratch;
    const auto dataset = written_box(scratch, box(2, 2, 2));
    const auto groups = dataset->groups(0);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].name, "wall");
    EXPECT_EQ(groups[0].of, Group::Of::faces);
    EXPECT_THAT(groups[0].ids, ElementsAre(0, 1, 24)) << "one of its faces is inside the mesh";
    EXPECT_EQ(groups[1].name, "inner/zone \xC3\xA9");
    EXPECT_EQ(groups[1].of, Group::Of::cells);
}

TEST(RoundTrip, ValuesAndGapsPerStep) {
    const Folder scratch;
    const auto dataset = written_box(scratch, box(2, 2, 2));
    ASSERT_EQ(dataset->steps().size(), 3U);
    EXPECT_THAT(dataset->values("p", 2), ElementsAreArray(values_of(27, 2)));
    EXPECT_THAT(dataset->values("U", 1), ElementsAreArray(values_of(81, 1)));
    EXPECT_THAT(dataset->values("cell:p", 1), ElementsAreArray(values_of(8, 1)));
    EXPECT_TRUE(dataset->values("p", 1).empty()) << "p was not written at 0.5: never zeros";
    EXPECT_EQ(dataset->steps()[1].arrays.count("p"), 0U);
    EXPECT_THAT(dataset->steps()[2].arrays.at("p").range, ElementsAre(2000, 2026));
    EXPECT_EQ(dataset->find("U")->units, "m/s");
    EXPECT_EQ(dataset->find("U")->description, "velocity");
    EXPECT_EQ(dataset->step_at(0.6), 1U);
    EXPECT_THROW((void)dataset->values("q", 0), Error);
    EXPECT_THROW((void)dataset->values("p", 3), Error);
}

TEST(RoundTrip, RangesAreOfMagnitudeAndIgnoreWhatIsNotFinite) {
    const Folder scratch;
    Writer writer(scratch / "r.ciel", {});
    writer.add_mesh(box(1, 1, 1), identity(8), identity(1), {});
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<float> u{3, -4, 0, 0, 0, 0, 1, 1, nan, 0, 0, 0, 0, 0, 0, inf, 0, 0, 0, 0, 0, 0, 0, 0};
    const std::vector<float> s{nan, nan, nan, nan, nan, nan, nan, nan};
    const std::vector<ArrayValues> arrays{{{"U", Association::point, 3, "", ""}, u},
                                          {{"s", Association::point, 1, "", ""}, s}};
    writer.add_step(0, 0, 0, arrays);
    writer.finish();
    const auto dataset = Dataset::open(scratch / "r.ciel");
    const ArrayStep& step = dataset->steps()[0].arrays.at("U");
    EXPECT_THAT(step.range, ElementsAre(0, 5));
    EXPECT_THAT(step.component_ranges, ElementsAre(ElementsAre(0, 3), ElementsAre(-4, 1), ElementsAre(0, 0)));
    EXPECT_EQ(step.invalid, 2U);
    EXPECT_THAT(dataset->steps()[0].arrays.at("s").range, ElementsAre(0, 0));
    EXPECT_EQ(dataset->steps()[0].arrays.at("s").invalid, 8U);
}

// Two cells that are neighbors along x.
std::shared_ptr<Dataset> two_cells(const Folder& scratch, const std::vector<ArrayValues>& arrays,
                                   const SolverIds& ids = {}) {
    FaceMesh mesh = box(2, 1, 1);
    mesh.origin = {100, 0, 0};
    Writer writer(scratch / "two.ciel", {});
    writer.add_mesh(mesh, identity(12), identity(2), {}, ids);
    writer.add_step(0, 0, 0, arrays);
    writer.finish();
    return Dataset::open(scratch / "two.ciel");
}

TEST(RoundTrip, ExtremesOfCellsWithTheirPlaces) {
    const Folder scratch;
    const std::vector<float> p{7, -2}, u{0, 9, 0, 1, 1, 1};
    const auto dataset = two_cells(
        scratch, {{{"cell:p", Association::cell, 1, "", ""}, p}, {{"cell:U", Association::cell, 3, "", ""}, u}});
    const auto& scalar = dataset->steps()[0].arrays.at("cell:p").extremes;
    ASSERT_EQ(scalar.size(), 1U);
    EXPECT_EQ(scalar[0].lowest.cell, 1U);
    EXPECT_THAT(scalar[0].lowest.place, ElementsAre(101.5, 0.5, 0.5));
    EXPECT_EQ(scalar[0].highest.cell, 0U);
    EXPECT_THAT(scalar[0].highest.place, ElementsAre(100.5, 0.5, 0.5));
    const auto& vector = dataset->steps()[0].arrays.at("cell:U").extremes;
    ASSERT_EQ(vector.size(), 4U) << "of the magnitude and of each component";
    EXPECT_EQ(vector[0].highest.cell, 0U);
    EXPECT_EQ(vector[1].highest.cell, 1U);
}

TEST(RoundTrip, NoExtremesOfPointsAndOfNoNumbers) {
    const Folder scratch;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> points(12, 1), cells{nan, nan};
    const auto dataset = two_cells(
        scratch, {{{"p", Association::point, 1, "", ""}, points}, {{"cell:p", Association::cell, 1, "", ""}, cells}});
    for (const char* name : {"p", "cell:p"}) EXPECT_TRUE(dataset->steps()[0].arrays.at(name).extremes.empty()) << name;
}

TEST(RoundTrip, IdsOfTheSolver) {
    const Folder scratch;
    std::vector<std::int64_t> vertices(12), cells{5'000'000'000, -1};
    std::iota(vertices.begin(), vertices.end(), 100);
    const auto dataset = two_cells(scratch, {}, {vertices, cells});
    EXPECT_THAT(dataset->solver_vertex(0), ElementsAreArray(vertices));
    EXPECT_THAT(dataset->solver_cell(0), ElementsAreArray(cells));
    for (Index cell = 0; cell < cells.size(); ++cell)
        EXPECT_EQ(dataset->solver_cell(0, cell), cells[cell] < 0 ? std::nullopt : std::optional(cells[cell]));
    for (Index vertex = 0; vertex < vertices.size(); ++vertex)
        EXPECT_EQ(dataset->solver_vertex(0, vertex),
                  vertices[vertex] < 0 ? std::nullopt : std::optional(vertices[vertex]));
    const Folder other;
    EXPECT_TRUE(two_cells(other, {})->solver_cell(0).empty());
    const std::vector<std::int64_t> too_few{1};
    EXPECT_THROW((void)two_cells(Folder(), {}, {{}, too_few}), Error);
}

TEST(RoundTrip, ValuesOfTheBoundarysFacesAndWhereArraysComeFrom) {
    const Folder scratch;
    ArrayInfo info{"patch:p", Association::boundary_face, 1, "Pa", ""};
    info.source = {Origin::derived, "float64", "processor*/0/p"};
    const std::vector<float> faces{0, 1, 2, 3, 4, 5, 6, 7, 8, no_value};
    const auto dataset = two_cells(scratch, {{info, faces}});
    const ArrayInfo& read = *dataset->find("patch:p");
    EXPECT_EQ(read.association, Association::boundary_face);
    EXPECT_EQ(read.source.origin, Origin::derived);
    EXPECT_EQ(read.source.type, "float64");
    EXPECT_EQ(read.source.file, "processor*/0/p");
    const auto values = dataset->values("patch:p", 0);
    ASSERT_EQ(values.size(), 10U);
    EXPECT_EQ(values[8], 8);
    EXPECT_TRUE(is_no_value(values[9])) << "which value is none survives the disk";
}

TEST(RoundTrip, TensorsHaveNamesAndTheFrobeniusNorm) {
    const Folder scratch;
    ArrayInfo symmetric{"R", Association::cell, 6, "", ""};
    symmetric.component_names = {"xx", "xy", "xz", "yy", "yz", "zz"};
    ArrayInfo full = symmetric;
    full.name = "T";
    full.components = 9;
    full.component_names = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    const std::vector<float> six{1, 2, 0, 3, 0, 4, 0, 0, 0, 0, 0, 0},
        nine{1, 2, 0, 2, 3, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    const std::vector<float> four{1, -3, 5, 2, 0, 0, 0, 0};
    const auto dataset =
        two_cells(scratch, {{symmetric, six}, {full, nine}, {{"A", Association::cell, 4, "", ""}, four}});
    EXPECT_THAT(scalar_names(*dataset->find("R")),
                ElementsAre("R:magnitude", "R:xx", "R:xy", "R:xz", "R:yy", "R:yz", "R:zz"));
    EXPECT_EQ(parse_scalar(*dataset, "R:yy").component, 3);
    EXPECT_FLOAT_EQ(static_cast<float>(dataset->steps()[0].arrays.at("R").range[1]), std::sqrt(34.0F));
    EXPECT_FLOAT_EQ(static_cast<float>(dataset->steps()[0].arrays.at("T").range[1]), std::sqrt(34.0F));
    EXPECT_THAT(scalar_names(*dataset->find("A")), ElementsAre("A:0", "A:1", "A:2", "A:3")) << "no magnitude";
    EXPECT_THAT(dataset->steps()[0].arrays.at("A").range, ElementsAre(-3, 5)) << "of all components";
    const auto refusal = [&](const std::string& name) -> std::string {
        try {
            (void)parse_scalar(*dataset, name);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("R:1"),
              "array 'R' has no component '1'; choose one of R:magnitude, R:xx, R:xy, R:xz, R:yy, R:yz, "
              "R:zz");
    EXPECT_EQ(refusal("A"), "'A' has 4 components and no magnitude; choose one of A:0, A:1, A:2, A:3");
    EXPECT_EQ(refusal("A:magnitude"), "array 'A' has no component 'magnitude'; choose one of A:0, A:1, A:2, A:3");
}

TEST(RoundTrip, MovingMeshAndRemeshing) {
    const Folder scratch;
    const FaceMesh coarse = box(1, 1, 1);
    FaceMesh fine = box(2, 1, 1);
    fine.origin = {500000.125, 5000000.25, 0};
    Writer writer(scratch / "m.ciel", {});
    writer.add_mesh(coarse, identity(8), identity(1), {});
    std::vector<float> moved = coarse.positions;
    for (float& x : moved) x *= 2;
    EXPECT_EQ(writer.add_coordinates(0, moved), 1U);
    EXPECT_EQ(writer.add_mesh(fine, identity(12), identity(2), {}), 1U);
    const auto p0 = values_of(8, 0), p1 = values_of(8, 1), p2 = values_of(12, 2);
    const ArrayInfo p{"p", Association::point, 1, "", ""};
    writer.add_step(0, 0, 0, std::vector<ArrayValues>{{p, p0}});
    writer.add_step(1, 0, 1, std::vector<ArrayValues>{{p, p1}});
    writer.add_step(2, 1, 0, std::vector<ArrayValues>{{p, p2}});
    writer.finish();
    const auto dataset = Dataset::open(scratch / "m.ciel");
    ASSERT_EQ(dataset->info().meshes.size(), 2U);
    EXPECT_EQ(dataset->steps()[1].coordinates, 1U);
    EXPECT_EQ(dataset->steps()[2].mesh, 1U);
    EXPECT_THAT(dataset->mesh_arrays().all_faces(0, 1).positions, ElementsAreArray(moved));
    EXPECT_EQ(dataset->mesh_arrays().all_faces(1, 0).origin, fine.origin);
    EXPECT_THAT(dataset->info().meshes[0].bounds, ElementsAre(0, 2, 0, 2, 0, 2));
    EXPECT_DOUBLE_EQ(dataset->info().meshes[1].bounds[1], 500002.125);
    EXPECT_THAT(dataset->values("p", 2), ElementsAreArray(p2));
    EXPECT_THROW((void)dataset->mesh_arrays().all_faces(0, 2), Error);
    EXPECT_THROW((void)dataset->mesh_arrays().all_faces(2, 0), Error);
}

TEST(Append, AStepIsSeenByRefreshedOnly) {
    const Folder scratch;
    const FaceMesh mesh = box(2, 2, 2);
    const auto dataset = written_box(scratch, mesh);
    EXPECT_EQ(dataset->refreshed(), nullptr);
    const auto before = dataset->values("p", 0);
    {
        Writer writer = Writer::append(scratch / "box.ciel");
        const auto p = values_of(27, 3), t = values_of(27, 7);
        const std::vector<ArrayValues> arrays{{{"p", Association::point, 1, "Pa", ""}, p},
                                              {{"tracer", Association::point, 1, "", ""}, t}};
        EXPECT_THROW(writer.add_step(1.0, 0, 0, arrays), Error) << "not later than the last";
        writer.add_step(1.5, 0, 0, arrays); // visible to readers before finish()
        EXPECT_THROW((void)Writer::append(scratch / "box.ciel"), Error) << "one appender at a time";
    }
    EXPECT_EQ(dataset->steps().size(), 3U);
    const auto now = dataset->refreshed();
    ASSERT_NE(now, nullptr);
    ASSERT_EQ(now->steps().size(), 4U);
    EXPECT_THAT(now->values("p", 3), ElementsAreArray(values_of(27, 3)));
    EXPECT_THAT(now->values("tracer", 3), ElementsAreArray(values_of(27, 7)));
    EXPECT_TRUE(now->values("tracer", 0).empty());
    EXPECT_TRUE(now->values("U", 3).empty());
    EXPECT_EQ(now->values("p", 0).data(), before.data()) << "chunks stay mapped once";
    EXPECT_EQ(now->refreshed(), nullptr);
}

TEST(Append, AMovedMeshAndANewMeshCome) {
    const Folder scratch;
    const auto dataset = written_box(scratch, box(2, 2, 2));
    Writer writer = Writer::append(scratch / "box.ciel");
    std::vector<float> moved = box(2, 2, 2).positions;
    for (float& x : moved) x += 1;
    const auto coordinates = writer.add_coordinates(0, moved);
    const auto p = values_of(27, 3), q = values_of(8, 4);
    const ArrayInfo info{"p", Association::point, 1, "Pa", ""};
    writer.add_step(2, 0, coordinates, std::vector<ArrayValues>{{info, p}});
    const auto moving = dataset->refreshed();
    ASSERT_NE(moving, nullptr);
    EXPECT_THAT(moving->mesh_arrays().all_faces(0, moving->steps().back().coordinates).positions,
                ElementsAreArray(moved));
    const auto mesh = writer.add_mesh(box(1, 1, 1), identity(8), identity(1), {});
    EXPECT_EQ(moving->refreshed(), nullptr) << "a mesh without a step is not there yet";
    writer.add_step(3, mesh, 0, std::vector<ArrayValues>{{info, q}});
    writer.finish();
    const auto remeshed = moving->refreshed();
    ASSERT_NE(remeshed, nullptr);
    EXPECT_EQ(remeshed->info().meshes.size(), 2U);
    EXPECT_THAT(remeshed->values("p", 4), ElementsAreArray(q));
    EXPECT_THAT(remeshed->values("p", 3), ElementsAreArray(p));
}

TEST(ScalarNames, VectorsHaveComponentsAndMagnitude) {
    const Folder scratch;
    const auto dataset = written_box(scratch, box(1, 1, 1));
    EXPECT_THAT(scalar_names(*dataset->find("U")), ElementsAre("U:magnitude", "U:x", "U:y", "U:z"));
    EXPECT_THAT(scalar_names(*dataset->find("cell:p")), ElementsAre("cell:p"));
    EXPECT_TRUE(parse_scalar(*dataset, "U:magnitude").magnitude);
    EXPECT_TRUE(parse_scalar(*dataset, "U").magnitude);
    EXPECT_EQ(parse_scalar(*dataset, "U:z").component, 2);
    EXPECT_EQ(parse_scalar(*dataset, "U:1").component, 1);
    EXPECT_EQ(parse_scalar(*dataset, "cell:p").array, "cell:p");
    for (const char* name : {"", "U:w", "U:3", "p:x", ":", "cell:"})
        EXPECT_THROW((void)parse_scalar(*dataset, name), Error) << name;
}

} // namespace
} // namespace server::store
