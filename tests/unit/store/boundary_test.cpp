// The boundary faces of a stored mesh: those of the list of all faces, whether they were stored or not.
#include "store/dataset.hpp"
#include "store/format/layout.hpp"
#include "support/store_box/box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAreArray;

class BoundaryTest : public testing::Test {
protected:
    BoundaryTest() { test::write_box(directory, test::box(5, 4, 3)); }

    // As a CIEL that stored no boundary wrote it.
    void remove_boundary() const {
        fs::remove_all(directory / "meshes/0/boundary");
        const fs::path document = directory / "meshes/0/.zattrs";
        nlohmann::json attributes = nlohmann::json::parse(test::read_file(document));
        for (const char* array : layout::boundary_arrays) attributes["ciel"]["checksums"].erase(array);
        test::overwrite_file(document, attributes.dump());
    }
    static void expect_boundary(const Dataset& dataset) {
        const FaceMeshView all = dataset.mesh(0, 0);
        const BoundaryFaceLists expected = boundary_face_lists(all);
        const BoundaryFaces found = dataset.boundary(0, 0);
        EXPECT_EQ(found.mesh.face_count(), 2U * (5 * 4 + 5 * 3 + 4 * 3));
        EXPECT_THAT(found.mesh.face_offset.unchecked(), ElementsAreArray(expected.face_offset));
        EXPECT_THAT(found.mesh.face_vertex.unchecked(), ElementsAreArray(expected.face_vertex));
        EXPECT_THAT(found.mesh.owner.unchecked(), ElementsAreArray(expected.owner));
        EXPECT_THAT(found.face.unchecked(), ElementsAreArray(expected.face));
        for (Index number = 0; number < found.mesh.face_count(); ++number) {
            EXPECT_EQ(found.mesh.neighbour[number], none);
            EXPECT_EQ(all.neighbour[found.face[number]], none);
        }
        EXPECT_EQ(found.mesh.vertex_count(), all.vertex_count());
        EXPECT_EQ(found.mesh.cell_count(), all.cell_count());
        const std::vector<Index> faces{found.face[7], 1, found.face[0]};
        EXPECT_EQ(boundary_numbers(found, faces), boundary_numbers(all, faces));
    }

    test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
};

TEST_F(BoundaryTest, IsThatOfAllFaces) {
    const auto dataset = Dataset::open(directory);
    expect_boundary(*dataset);
    EXPECT_NO_THROW(dataset->verify());
}

TEST_F(BoundaryTest, IsMadeIfItWasNotStored) {
    remove_boundary();
    const auto dataset = Dataset::open(directory);
    expect_boundary(*dataset);
    EXPECT_NO_THROW(dataset->verify());
}

TEST_F(BoundaryTest, IsReadWithoutTheOtherFaces) {
    test::overwrite_file(directory / "meshes/0/face_vertex/0",
                         std::string(fs::file_size(directory / "meshes/0/face_vertex/0"), 'x'));
    const auto dataset = Dataset::open(directory);
    EXPECT_EQ(dataset->boundary(0, 0).mesh.loop(3).size(), 4U);
    EXPECT_THROW((void)dataset->mesh(0, 0), Error);
}

TEST_F(BoundaryTest, IsRefusedByNameOfFileWhenItIsDamaged) {
    const fs::path file = directory / "meshes/0/boundary/owner/0";
    std::string content = test::read_file(file);
    content[4] ^= 1;
    test::overwrite_file(file, content);
    try {
        (void)Dataset::open(directory)->boundary(0, 0);
        FAIL() << "passed";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(testing::HasSubstr(file.string()), testing::HasSubstr("checksum")));
    }
}

} // namespace
} // namespace ciel::store
