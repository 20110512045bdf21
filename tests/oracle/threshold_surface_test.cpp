// Threshold surfaces against a brute-force test of each cell, without owners, neighbors or blocks.
#include "ciel/cell_limits.hpp"
#include "ciel/clip_surface.hpp"
#include "ciel/threshold_surface.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/boundary.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "support/volume_property.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <ranges>
#include <set>

namespace ciel::test {
using namespace server;
namespace {

using Sides = std::vector<std::pair<Id, Loop>>; // sorted pairs of an input cell and one of its faces

// Removes consecutive duplicates: collapsed edges are not part of a surface.
Loop without_repeats(Loop loop) {
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
}

// A face of a kept cell is on the boundary when no other kept cell has a face with the same vertices.
Sides kept_boundary(const Polyhedra& mesh, const std::vector<float>& values, std::array<double, 2> range,
                    InRange rule) {
    Sides all;
    std::map<std::vector<Id>, int> count;
    const auto vertices_of = [](Loop loop) {
        std::sort(loop.begin(), loop.end());
        return loop;
    };
    for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
        bool every = true, some = false;
        for (const Loop& loop : mesh.loops(cell))
            for (const Id vertex : loop) {
                const bool inside = values[vertex] >= range[0] && values[vertex] <= range[1];
                every = every && inside;
                some = some || inside;
            }
        if (!(rule == InRange::all ? every : some)) continue;
        for (const Loop& side : mesh.loops(cell)) {
            const Loop loop = without_repeats(side);
            if (loop.size() < 3) continue;
            all.emplace_back(cell, canonical(loop));
            ++count[vertices_of(loop)];
        }
    }
    std::erase_if(all, [&](const auto& side) { return count[vertices_of(side.second)] != 1; });
    std::sort(all.begin(), all.end());
    return all;
}

Sides in_ids_of_the_input(const Surface& surface, const KernelMesh& mesh) {
    Sides sides;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        Loop loop;
        for (const Index point : polygon(surface, i)) {
            EXPECT_EQ(surface.points[point].a, surface.points[point].b);
            loop.push_back(mesh.assembled.original_vertex[surface.points[point].a]);
        }
        sides.emplace_back(mesh.assembled.original_cell[surface.polygon_cell[i]], canonical(without_repeats(loop)));
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

class ThresholdSurface : public testing::TestWithParam<NamedMesh> {};

TEST_P(ThresholdSurface, IsTheBoundaryOfTheCellsKept) {
    const Polyhedra input = GetParam().make();
    const KernelMesh mesh(input, {32});
    std::vector<float> values = random_field(input.vertex_count(), 8);
    for (std::size_t v = 0; v < values.size(); v += 17) values[v] = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> stored = mesh.stored(values);
    for (const InRange rule : {InRange::all, InRange::any})
        for (const std::array<double, 2> range : {std::array{0.1, 0.95}, {0.4, 0.5}, {0.0, 1.0}, {2.0, 3.0}}) {
            const auto kept = cells_in_range(mesh.mesh(), stored, range, rule);
            EXPECT_EQ(in_ids_of_the_input(threshold_surface(mesh.mesh(), kept), mesh),
                      kept_boundary(input, values, range, rule))
                << range[0] << ' ' << range[1] << ' ' << (rule == InRange::all ? "all" : "any");
        }
}

// Compares the surface made from blocks with the one made from the list of all faces, for blocks of several sizes. The
// smooth field has blocks inside the range, outside, and across its ends. `by_blocks` keeps every second block as a
// whole.
TEST_P(ThresholdSurface, OfBlocksIsThatOfTheListOfFaces) {
    const Polyhedra input = GetParam().make();
    for (const Index cells : {1U, 7U, 4096U}) {
        const KernelMesh mesh(input, {cells});
        const Boundary boundary(mesh.mesh());
        const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
        std::vector<float> smooth = linear_field(input, {{1, 0.3, 0.2}}), noise = random_field(input.vertex_count(), 8);
        smooth.resize(std::max<std::size_t>(smooth.size(), 1)); // for a mesh without vertices
        const auto [low, high] = std::ranges::minmax(smooth);
        smooth.resize(input.vertex_count());
        for (std::size_t v = 0; v < noise.size(); v += 17) noise[v] = std::numeric_limits<float>::quiet_NaN();
        std::vector<std::uint8_t> by_blocks(mesh.mesh().cell_count());
        for (std::size_t cell = 0; cell < by_blocks.size(); ++cell) by_blocks[cell] = cell / cells % 2 == 0 ? 1 : 0;
        const auto compare = [&](std::span<const std::uint8_t> kept) {
            const Surface found = threshold_surface(mesh.topology, boundary.faces(), boxes, kept);
            const Surface wanted = threshold_surface(mesh.mesh(), kept);
            EXPECT_EQ(in_ids_of_the_input(found, mesh), in_ids_of_the_input(wanted, mesh)) << cells;
            std::vector<Index> faces;
            for (const auto& [face, cell] : threshold_faces(mesh.mesh(), kept))
                if (mesh.mesh().neighbour[face] == none) faces.push_back(face);
            faces = boundary_numbers(mesh.mesh(), faces);
            std::vector<Index> named = found.polygon_face;
            std::erase(named, none);
            EXPECT_TRUE(std::ranges::includes(faces, named)) << "faces are named that are not on the boundary";
            EXPECT_EQ(found.points.size(), wanted.points.size());
        };
        for (const std::vector<float>& values : {smooth, noise})
            for (const InRange rule : {InRange::all, InRange::any})
                for (const std::array<double, 2> range : {std::array{0.3 * high + 0.7 * low, 0.8 * high + 0.2 * low},
                                                          {0.4, 0.5},
                                                          {-1e30, 1e30},
                                                          {2e30, 3e30}}) {
                    const std::vector<float> stored = mesh.stored(values);
                    const auto kept = cells_in_range(make_field(mesh.topology, stored), range, rule);
                    EXPECT_EQ(kept, cells_in_range(mesh.mesh(), stored, range, rule)) << cells << ' ' << range[0];
                    compare(kept);
                }
        compare(by_blocks);
    }
}

TEST_P(ThresholdSurface, OfBlocksHasCollapsedFacesIfTheyAreAskedFor) {
    const KernelMesh mesh(GetParam().make(), {7});
    const Boundary boundary(mesh.mesh());
    const FaceMeshView faces = boundary.faces();
    const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
    const std::vector<std::uint8_t> every(mesh.mesh().cell_count(), 1);
    std::vector<Index> all, of_three;
    for (Index face = 0; face < faces.face_count(); ++face) {
        const auto loop = faces.loop(face);
        all.push_back(face);
        if (std::set<Index>(loop.begin(), loop.end()).size() >= 3) of_three.push_back(face);
    }
    EXPECT_EQ(threshold_surface(mesh.topology, faces, boxes, every).polygon_face, of_three);
    EXPECT_EQ(threshold_surface(mesh.topology, faces, boxes, every, CollapsedFaces::keep).polygon_face, all);
}

TEST_P(ThresholdSurface, OfBlocksIgnoresFacesBetweenTwoCells) {
    const KernelMesh mesh(GetParam().make(), {7});
    const Boundary boundary(mesh.mesh());
    const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
    std::vector<std::uint8_t> kept(mesh.mesh().cell_count());
    for (std::size_t cell = 0; cell < kept.size(); cell += 3) kept[cell] = 1;
    EXPECT_EQ(in_ids_of_the_input(threshold_surface(mesh.topology, mesh.mesh(), boxes, kept), mesh),
              in_ids_of_the_input(threshold_surface(mesh.topology, boundary.faces(), boxes, kept), mesh));
}

// Sum of the area vectors of each cell's polygons. Unlike the polygons, it does not change when faces without an area
// are left out.
using Areas = std::map<Index, Vec3d>;

void add_polygon(Areas& areas, Index cell, const Vec3d& area) {
    for (std::size_t axis = 0; axis < 3; ++axis) areas[cell][axis] += area[axis];
}

TEST_P(ThresholdSurface, IsTheBoundaryOfAVolume) {
    const Polyhedra input = GetParam().make();
    for (const Index cells : {1U, 7U, 4096U})
        for (const Index one_in : {1U, 3U, 1000U}) {
            const KernelMesh mesh(input, {cells});
            const std::vector<float> values = mesh.stored(random_field(input.vertex_count(), 8));
            const std::vector<Vec3f> gradients(values.size());
            std::vector<std::uint8_t> kept(mesh.mesh().cell_count(), 0);
            for (Index cell = 0; cell < kept.size(); cell += one_in) kept[cell] = 1;
            const BlockBoxes boxes = block_boxes(mesh.topology, mesh.mesh().positions);
            const Boundary boundary(mesh.mesh());
            const Surface faces = threshold_surface(mesh.topology, boundary.faces(), boxes, kept, CollapsedFaces::keep);
            const color::SlabTriangles slab = geometry::slab_boundary(faces, {mesh.topology, values, gradients, kept});
            CellLimits limits(mesh.topology);
            Areas found, wanted;
            std::vector<Vec3f> positions;
            for (const color::SlabVertex& vertex : slab.vertices) positions.push_back(vertex.position);
            std::size_t at = 0;
            for (std::size_t face = 0; face < faces.polygon_cell.size(); ++face) {
                const Index cell = faces.polygon_cell[face];
                for (std::size_t k = 2; k < polygon(faces, face).size(); ++k, at += 3) {
                    EXPECT_EQ(slab.vertices.at(slab.triangles.at(at)).limits, limits.of(cell, values));
                    add_polygon(found, cell, vector_area(positions, std::span(slab.triangles).subspan(at, 3)));
                }
            }
            EXPECT_EQ(at, slab.triangles.size());
            const Surface surface = threshold_surface(mesh.mesh(), kept);
            for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i)
                add_polygon(wanted, surface.polygon_cell[i], vector_area(surface.positions, polygon(surface, i)));
            for (Index cell = 0; cell < kept.size(); ++cell)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    ASSERT_NEAR(found[cell][axis], wanted[cell][axis], 1e-4) << cells << ' ' << one_in << ' ' << cell;
        }
}

TEST_P(ThresholdSurface, CountsTheCellsAroundWhatWentWrong) {
    const Polyhedra input = GetParam().make();
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> values = random_field(input.vertex_count(), 8);
    for (std::size_t v = 0; v < values.size(); v += 40) values[v] = v % 80 == 0 ? infinity : nan;
    for (const Index cells : {1U, 7U, 4096U}) {
        const KernelMesh mesh(input, {cells});
        const std::vector<float> stored = mesh.stored(values);
        std::vector<float> marks(stored.size());
        std::ranges::transform(stored, marks.begin(), [](float value) { return std::isinf(value) ? 1.0F : 0.0F; });
        const auto beside = cells_in_range(mesh.mesh(), marks, {1, 1}, InRange::any);
        EXPECT_EQ(count_cells_without_value(make_field(mesh.topology, stored), stored,
                                            [](double value) { return std::isinf(value); }),
                  static_cast<std::size_t>(std::ranges::count(beside, 1)));
    }
}

INSTANTIATE_TEST_SUITE_P(meshes, ThresholdSurface, testing::ValuesIn(all_meshes()),
                         [](const auto& mesh) { return mesh.param.name; });

TEST(Threshold, EndsBelongToTheRangeAndWrongSizesAreRefused) {
    const Polyhedra input = hexahedra({{3, 1, 1}});
    const KernelMesh mesh(input);
    const std::vector<float> x = mesh.stored(linear_field(input, {{1, 0, 0}}));
    const auto count = [&](double low, double high, InRange rule) {
        const auto kept = cells_in_range(mesh.mesh(), x, {low, high}, rule);
        return std::count(kept.begin(), kept.end(), 1);
    };
    EXPECT_EQ(count(1, 2, InRange::all), 1);
    EXPECT_EQ(count(1, 2, InRange::any), 3);
    EXPECT_EQ(count(1.01, 2, InRange::all), 0);
    EXPECT_EQ(count(1, 3, InRange::all), 2);
    EXPECT_THROW((void)cells_in_range(mesh.mesh(), std::span(x).first(3), {0, 1}, InRange::all), Error);
}

TEST(Threshold, OfACutKeepsThePolygonsOfItsCells) {
    const Polyhedra input = hexahedra({{4, 4, 4}});
    const KernelMesh mesh(input);
    const Field field = make_field(mesh.topology, mesh.stored(linear_field(input, {{0, 0, 1}})));
    Query query = mesh.query();
    query.set_field(field);
    Surface cut;
    ASSERT_TRUE(query.extract(1.5, false, cut));
    const auto kept = cells_in_range(mesh.mesh(), mesh.stored(linear_field(input, {{1, 0, 0}})), {1, 3}, InRange::all);
    const Surface part = polygons_of_cells(cut, kept);
    EXPECT_EQ(part.polygon_cell.size(), 8U) << "two of four columns";
    EXPECT_EQ(part.positions.size(), 15U);
    for (const Vec3f& at : part.positions) EXPECT_TRUE(at[0] >= 1 && at[0] <= 3);
}

TEST(Threshold, OfAClippedSurfaceIsRefused) {
    const Polyhedra input = hexahedra({{4, 4, 4}});
    const KernelMesh mesh(input);
    const Field field = make_field(mesh.topology, mesh.stored(linear_field(input, {{0, 0, 1}})));
    Query query = mesh.query();
    query.set_field(field);
    Surface cut;
    ASSERT_TRUE(query.extract(1.5, false, cut));
    const std::vector<std::uint8_t> all(64, 1);
    const std::vector<HalfSpace> between{{{1, 0, 0}, -1.5}}, beside{{{1, 0, 0}, 1}};
    try {
        (void)polygons_of_cells(clip_surface(cut, {}, between, 0).surface, all);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("filter the surface before it is clipped"));
    }
    // The clip cuts nothing off, so all polygons are still those of cells.
    EXPECT_EQ(polygons_of_cells(clip_surface(cut, {}, beside, 0).surface, all).polygon_cell.size(), 16U);
    EXPECT_THROW((void)polygons_of_cells(cut, std::span(all).first(20)), Error);
}

} // namespace
} // namespace ciel::test
