// The numbered faces of a stored mesh are the same in both formats and are read without the other faces.
#include "ciel/mesh_faces.hpp"
#include "ciel/numbered_faces.hpp"
#include "store/dataset.hpp"
#include "store/mesh_arrays.hpp"
#include "support/store_box/box.hpp"
#include "support/store_box/format_1.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::ElementsAreArray;

class NumberedFacesTest : public testing::Test {
protected:
    NumberedFacesTest() { test::write_box(directory, mesh); }

    // Expects the boundary faces, followed by face 1, the only face of a group that is inside the mesh.
    void expect_faces(const Dataset& dataset) const {
        const FaceLists expected = numbered_faces(mesh.view(), std::vector<Index>{1});
        const FaceMeshView found = dataset.mesh_arrays().numbered_faces(0, 0),
                           boundary = dataset.mesh_arrays().boundary(0, 0);
        EXPECT_THAT(found.face_offset.unchecked(), ElementsAreArray(expected.face_offset));
        EXPECT_THAT(found.face_vertex.unchecked(), ElementsAreArray(expected.face_vertex));
        EXPECT_THAT(found.owner.unchecked(), ElementsAreArray(expected.owner));
        EXPECT_THAT(found.neighbour.unchecked(), ElementsAreArray(expected.neighbour));
        ASSERT_EQ(boundary.face_count(), on_boundary);
        for (Index number = 0; number < on_boundary; ++number) {
            EXPECT_EQ(boundary.neighbour[number], none);
            EXPECT_TRUE(std::ranges::equal(boundary.loop(number), found.loop(number)));
        }
        EXPECT_EQ(found.vertex_count(), mesh.view().vertex_count());
        EXPECT_EQ(found.cell_count(), mesh.view().cell_count());
        EXPECT_THAT(dataset.groups(0)[0].ids, ElementsAre(0, 1, on_boundary));
        EXPECT_THAT(dataset.groups(0)[1].ids, ElementsAre(0));
    }

    const FaceMesh mesh = test::box(5, 4, 3);
    const Index on_boundary = 2 * (5 * 4 + 5 * 3 + 4 * 3);
    test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
};

TEST_F(NumberedFacesTest, AreThoseOfTheBoundaryAndThenThoseOfGroups) {
    const auto dataset = Dataset::open(directory);
    expect_faces(*dataset);
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_EQ(dataset->info().format_version, 2);
}

TEST_F(NumberedFacesTest, AreMadeFromAllFacesInFormat1) {
    test::make_format_1(directory, mesh);
    expect_faces(*Dataset::open(directory));
    test::remove_blocks(directory);
    const auto dataset = Dataset::open(directory);
    expect_faces(*dataset);
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_EQ(dataset->info().format_version, 1);
}

TEST_F(NumberedFacesTest, AllFacesComeFromTheBlocks) {
    const auto dataset = Dataset::open(directory);
    const FaceMeshView all = dataset->mesh_arrays().all_faces(0, 0);
    EXPECT_EQ(all.face_count(), mesh.owner.size());
    EXPECT_THAT(all.owner.unchecked(), ElementsAreArray(mesh.owner));
    EXPECT_TRUE(same_cells(Topology(all), Topology(mesh.view())));
    EXPECT_EQ(dataset->mesh_arrays().all_faces(0, 0).owner.unchecked().data(), all.owner.unchecked().data())
        << "made twice";
    EXPECT_THAT(all.positions, ElementsAreArray(mesh.positions));
}

TEST_F(NumberedFacesTest, AreRefusedByNameOfFileWhenTheyAreDamaged) {
    const fs::path file = directory / "meshes/0/faces/owner/0";
    std::string content = test::read_file(file);
    content[4] ^= 1;
    test::overwrite_file(file, content);
    try {
        (void)Dataset::open(directory)->mesh_arrays().boundary(0, 0);
        FAIL() << "passed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(testing::HasSubstr(file.string()), testing::HasSubstr("checksum")));
    }
}

} // namespace
} // namespace server::store
