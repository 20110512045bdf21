// Double positions: what is read equals what was written, to the last bit, in every coordinate set.
#include "store/append.hpp"
#include "store/mesh_arrays.hpp"
#include "store/rewrite.hpp"
#include "support/store_box/box.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

using testing::ElementsAreArray;

class DoublePositions : public testing::Test {
protected:
    DoublePositions() {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            points.push_back(4.5e6 + 0.1 * double{mesh.positions[i]} + (i % 3 == 2 ? 1e-7 : 0));
    }

    [[nodiscard]] std::vector<double> moved(double by) const {
        std::vector<double> all = points;
        for (double& x : all) x += by;
        return all;
    }
    // Writes a step at the time 0.
    [[nodiscard]] Writer first_step(const std::filesystem::path& to) const {
        FaceMesh doubles = mesh;
        doubles.set_positions(points);
        Writer writer(to, {"box.vtu", "m", 27, 54, 8, {}});
        writer.add_mesh(doubles, test::identity(27), test::identity(8), {});
        writer.add_step(0, 0, 0, {});
        return writer;
    }
    // Writes steps at the times 0, 1 and 2; the mesh has moved at the last one.
    void write() const {
        Writer writer = first_step(directory);
        writer.add_step(1, 0, 0, {});
        writer.add_step(2, 0, writer.add_coordinates(0, moved(0.3)), {});
        writer.finish();
    }
    [[nodiscard]] std::shared_ptr<Dataset> open() const { return Dataset::open(directory); }

    test::Folder scratch;
    std::filesystem::path directory = scratch / "box.ciel";
    FaceMesh mesh = test::box(2, 2, 2);
    std::vector<double> points;
};

TEST_F(DoublePositions, AreReadAsTheyWereWritten) {
    write();
    const auto dataset = open();
    EXPECT_NO_THROW(dataset->verify());
    EXPECT_TRUE(dataset->info().meshes[0].double_positions);
    EXPECT_THAT(dataset->mesh_arrays().points(0, 0).positions, ElementsAreArray(points));
    EXPECT_THAT(dataset->mesh_arrays().points(0, 1).positions, ElementsAreArray(moved(0.3)));
    EXPECT_THAT(test::read_file(directory / "meshes/0/positions/.zarray"), testing::HasSubstr("\"<f8\""));
    EXPECT_EQ(dataset->info().meshes[0].bounds[1], moved(0.3)[3 * 26]);
    EXPECT_EQ(dataset->mesh_arrays().points(0, 0).origin, Vec3d{});
}

TEST_F(DoublePositions, HaveTheBoxesOfTheirBlocks) {
    write();
    const auto dataset = open();
    for (const std::size_t set : {0U, 1U}) {
        const auto stored = dataset->block_boxes(0, set);
        ASSERT_TRUE(stored);
        const BlockBoxes expected = block_boxes(dataset->topology(0), dataset->mesh_arrays().points(0, set).positions);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_EQ((*stored)[axis].low, expected[axis].low);
            EXPECT_EQ((*stored)[axis].high, expected[axis].high);
        }
    }
}

TEST_F(DoublePositions, AreFoundAndAddedByAnAppend) {
    write();
    auto writer = Writer::append(directory);
    EXPECT_EQ(writer.find_coordinates(0, moved(0.3)), 1U);
    EXPECT_EQ(writer.find_coordinates(0, moved(1e-9)), std::nullopt);
    const std::vector<float> floats(81, 0.5F);
    EXPECT_TRUE(writer.holds(0, floats));
    EXPECT_EQ(writer.add_coordinates(0, floats), 2U);
    writer.add_step(3, 0, 2, {});
    writer.finish();
    EXPECT_THAT(open()->mesh_arrays().points(0, 2).positions, testing::Each(0.5));
}

TEST_F(DoublePositions, ThatWouldBeRoundedAreRefused) {
    Writer writer(directory, {"box.vtu", "m", 27, 54, 8, {}});
    writer.add_mesh(mesh, test::identity(27), test::identity(8), {});
    EXPECT_FALSE(writer.holds(0, points));
    EXPECT_EQ(writer.find_coordinates(0, points), std::nullopt);
    EXPECT_THROW((void)writer.add_coordinates(0, points), Error);
    const std::vector<double> exact(81, 0.5);
    EXPECT_TRUE(writer.holds(0, exact));
    EXPECT_EQ(writer.add_coordinates(0, exact), 1U);
    writer.add_step(0, 0, 1, {});
    writer.finish();
    EXPECT_FALSE(open()->info().meshes[0].double_positions);
    EXPECT_THAT(open()->mesh_arrays().points(0, 1).positions.floats(), testing::Each(0.5F));
}

TEST_F(DoublePositions, ThatAreNotFiniteAreRefused) {
    points[4] = std::nan("");
    EXPECT_THROW(write(), Error);
    points[4] = std::numeric_limits<double>::infinity();
    EXPECT_THROW(write(), Error);
}

TEST_F(DoublePositions, AreWrittenAgainAsTheyAre) {
    write();
    const std::filesystem::path again = scratch / "again.ciel";
    EXPECT_TRUE(rewrite(directory, again, false, [](double) {}).empty());
    const auto dataset = Dataset::open(again);
    EXPECT_THAT(dataset->mesh_arrays().points(0, 0).positions, ElementsAreArray(points));
    EXPECT_THAT(dataset->mesh_arrays().points(0, 1).positions, ElementsAreArray(moved(0.3)));
}

TEST_F(DoublePositions, OfAnotherDatasetAreAppended) {
    write();
    const std::filesystem::path first = scratch / "first.ciel";
    first_step(first).finish();
    EXPECT_EQ(append_dataset(Dataset::open(first), *open()), 2U);
    const auto dataset = Dataset::open(first);
    ASSERT_EQ(dataset->steps().size(), 3U);
    EXPECT_THAT(dataset->mesh_arrays().points(0, dataset->steps()[2].coordinates).positions,
                ElementsAreArray(moved(0.3)));
    EXPECT_EQ(dataset->steps()[1].coordinates, 0U);
}

} // namespace
} // namespace server::store
