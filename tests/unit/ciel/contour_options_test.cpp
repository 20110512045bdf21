// Tests the options of contour.hpp that do not change the surface, and its functions sweep and clip.
#include "ciel/contour.hpp"
#include "ciel/parallel.hpp"
#include "support/thread_count.hpp"
#include "unit/ciel/equal_surfaces.hpp"
#include "unit/ciel/meshes.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>

namespace ciel::test {
namespace {

// 24 x 24 x 24 unit cells, which make several blocks. Neighboring points and cells have distant ids.
class Cubes : public testing::Test {
protected:
    static constexpr Index n = 24;

    Cubes() : mesh(made()) {
        for (Index v = 0; v < mesh.point_count(); ++v)
            radius.push_back(std::hypot(x(v) - 11.3, y(v) - 12, z(v) - 12.4));
    }

    Mesh made() {
        const Polyhedra grid = hexahedra(n, n, n);
        const std::size_t points = grid.positions.size() / 3, cells = grid.types.size();
        positions.resize(grid.positions.size());
        for (std::size_t i = 0; i < points; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                positions[3 * new_point(i, points) + axis] = grid.positions[3 * i + axis];
        std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
        std::vector<Index> face_vertex;
        for (std::size_t c = 0; c < cells; ++c) {
            const std::size_t from = c * 5 % cells;
            for (std::uint64_t f = grid.cell_offset[from]; f < grid.cell_offset[from + 1]; ++f) {
                for (std::uint64_t k = grid.face_offset[f]; k < grid.face_offset[f + 1]; ++k)
                    face_vertex.push_back(static_cast<Index>(new_point(grid.face_vertex[k], points)));
                face_offset.push_back(face_vertex.size());
            }
            cell_offset.push_back(face_offset.size() - 1);
        }
        return Mesh::from_polyhedra({positions, 3}, cell_offset, face_offset, face_vertex);
    }
    static std::size_t new_point(std::size_t point, std::size_t points) { return point * 7 % points; }
    [[nodiscard]] double x(Index v) const { return double{positions[3 * std::size_t{v}]}; }
    [[nodiscard]] double y(Index v) const { return double{positions[3 * std::size_t{v} + 1]}; }
    [[nodiscard]] double z(Index v) const { return double{positions[3 * std::size_t{v} + 2]}; }

    std::vector<float> positions;
    Mesh mesh;
    std::vector<double> radius;
};

// Each polygon as its cell and the mesh edges of its corners, in no order.
using Polygons = std::multiset<std::pair<Index, std::set<std::pair<Index, Index>>>>;
void add(std::span<const EdgePoint> points, std::span<const Index> loop, Index cell, Polygons& to) {
    std::set<std::pair<Index, Index>> corners;
    for (const Index p : loop) corners.insert(std::minmax(points[p].a, points[p].b));
    to.emplace(cell, corners);
}
void add(const Surface& surface, Polygons& to) {
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const Index begin = surface.polygon_offset[i], end = surface.polygon_offset[i + 1];
        add(surface.points, std::span(surface.polygon_vertex).subspan(begin, end - begin), surface.polygon_cell[i], to);
    }
}

TEST_F(Cubes, AnyNumberOfThreadsGivesTheSameSurface) {
    ASSERT_GT(mesh.topology().block_count(), 3U);
    const std::vector<double> levels{6, 9.5, 3.25};
    const std::vector<Surface> wanted = contour(mesh, radius, levels);
    const Surface wanted_slice = slice(mesh, {12, 12, 12}, {1, 2, 3});
    for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation, Algorithm::naive})
        for (const unsigned threads : {1U, 2U, 5U}) {
            const std::vector<Surface> found =
                contour(mesh, radius, levels, {.algorithm = algorithm, .threads = threads});
            for (std::size_t i = 0; i < levels.size(); ++i) expect_equal(found[i], wanted[i]);
            expect_equal(slice(mesh, {12, 12, 12}, {1, 2, 3}, {.algorithm = algorithm, .threads = threads}),
                         wanted_slice);
        }
}

TEST_F(Cubes, ThreadsOfACallAreBounded) {
    const ThreadCount six(6);
    const std::vector<double> levels{3, 5, 7, 9, 11};
    for (const unsigned threads : {1U, 2U}) {
        std::mutex mutex;
        std::set<std::thread::id> seen;
        const OnCut note_thread = [&](std::size_t, Index, const BlockPolygons&) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5)); // time for another thread to come
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        };
        EXPECT_TRUE(sweep(mesh, radius, levels, note_thread, {.threads = threads}));
        EXPECT_LE(seen.size(), threads);
        EXPECT_EQ(thread_count(), 6U) << "nothing global has changed";
    }
}

TEST_F(Cubes, SurfacesOfBlocksMakeUpTheWhole) {
    Polygons whole, together;
    add(contour(mesh, radius, 8), whole);
    const std::size_t block_count = mesh.topology().block_count();
    for (Index b = 0; b < block_count; b += 2) {
        std::vector<Index> blocks{b};
        if (b + 1 < block_count) blocks.push_back(b + 1);
        const Surface part = contour(mesh, radius, 8, {.blocks = blocks});
        for (const Surface::Chunk& chunk : part.chunks) EXPECT_THAT(blocks, testing::Contains(chunk.block));
        add(part, together);
    }
    EXPECT_EQ(together, whole);
    EXPECT_THROW((void)contour(mesh, radius, 8, {.blocks = std::vector<Index>{99}}), Error);
}

TEST_F(Cubes, SweepsInTheCallersIds) {
    const std::vector<double> levels{9, 4};
    std::vector<Polygons> wanted(2), found(2);
    for (std::size_t i = 0; i < levels.size(); ++i) add(contour(mesh, radius, levels[i]), wanted[i]);
    std::mutex mutex;
    const OnCut keep = [&](std::size_t value, Index, const BlockPolygons& cut) {
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i < cut.polygon_count(); ++i)
            add(cut.points, cut.polygon(i), cut.cell_begin + cut.polygon_cell[i], found[value]);
    };
    EXPECT_TRUE(sweep(mesh, radius, levels, keep));
    EXPECT_EQ(found, wanted);
    EXPECT_THROW(sweep(mesh, radius, levels, keep, {.blocks = std::vector<Index>{0}}), Error);
}

TEST_F(Cubes, ClipsInTheCallersCoordinates) {
    const Surface sphere = contour(mesh, radius, 8);
    std::vector<double> heights;
    for (Index v = 0; v < mesh.point_count(); ++v) heights.push_back(z(v));
    const std::vector<HalfSpace> planes{{{0, 0, 1}, -10.25}, {{-2, 0, 0}, 26}}; // z >= 10.25, x <= 13
    const ClippedSurface part = clip(sphere, mesh, heights, planes);
    ASSERT_EQ(part.values.size(), part.surface.positions.size());
    double lowest = 99, rightmost = -99;
    for (std::size_t i = 0; i < part.values.size(); ++i) {
        const double height = mesh.stored().surface_origin[2] + double{part.surface.positions[i][2]};
        EXPECT_NEAR(part.values[i], height, 1e-4);
        lowest = std::min(lowest, height);
        rightmost = std::max(rightmost, mesh.stored().surface_origin[0] + double{part.surface.positions[i][0]});
    }
    EXPECT_NEAR(lowest, 10.25, 1e-4);
    EXPECT_NEAR(rightmost, 13, 1e-4);
    EXPECT_TRUE(clip(sphere, mesh, {}, planes).values.empty());
    EXPECT_THROW((void)clip(sphere, mesh, std::vector<double>(3), planes), Error);
    EXPECT_THROW((void)interpolate(part.surface, mesh, heights), Error) << "new points lie on no edge";
}

TEST_F(Cubes, InterpolatesValuesOfCellsAsFieldsDo) {
    std::vector<double> of_cells(2 * mesh.cell_count());
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
        of_cells[2 * c] = std::sin(static_cast<double>(c));
        of_cells[2 * c + 1] = static_cast<double>(c);
    }
    const ArrayView table(of_cells, 2);
    Surface surface;
    ASSERT_TRUE(Contour(Field::from_cells(mesh, table.column(0))).at(0.1, surface));
    const std::vector<double> found = interpolate(surface, mesh, table, true);
    ASSERT_EQ(found.size(), 2 * surface.points.size());
    for (std::size_t i = 0; i < surface.points.size(); ++i) EXPECT_NEAR(found[2 * i], 0.1, 1e-9);
    EXPECT_THROW((void)interpolate(surface, mesh, radius, true), Error);
}

// While a callback waits for a loop that it started, its thread must not begin another call of the callback.
TEST_F(Cubes, SweepCallbacksMayStartLoops) {
    const std::vector<double> levels{4, 6, 8, 10};
    static thread_local int inside = 0;
    std::atomic<int> again{0};
    const OnCut on_cut = [&](std::size_t, Index, const BlockPolygons& cut) {
        again += inside > 0 ? 1 : 0;
        ++inside;
        const std::vector<Vec3f> before(cut.positions.begin(), cut.positions.end());
        parallel_for(64, 1,
                     [](std::size_t, std::size_t) { std::this_thread::sleep_for(std::chrono::microseconds(20)); });
        again += std::equal(before.begin(), before.end(), cut.positions.begin(), cut.positions.end()) ? 0 : 1;
        --inside;
    };
    const ThreadCount threads(4);
    for (int repeat = 0; repeat < 10; ++repeat) EXPECT_TRUE(sweep(mesh, radius, levels, on_cut));
    EXPECT_EQ(again, 0);
}

TEST_F(Cubes, RefusesToInterpolateWhatDoesNotFit) {
    Surface surface = contour(mesh, radius, 8);
    EXPECT_THROW(
        (void)interpolate(surface, mesh, ArrayView(radius.data(), NumberType::float64, radius.size(), 0, 8, 8)), Error);
    surface.points.front().a = mesh.point_count();
    EXPECT_THROW((void)interpolate(surface, mesh, radius), Error);
}

} // namespace
} // namespace ciel::test
