#include "wire/files/joined_surface.hpp"
#include "wire/files/surface_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace server::wire {
using namespace ciel;
namespace {

// Two triangles. Points 2 and 3 are both on mesh vertex 7, so the second triangle becomes a sliver when they are
// joined.
Surface touching() {
    Surface surface;
    surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
    surface.normals.assign(4, {0, 0, 1});
    surface.points = {{0, 1, 0.5F}, {1, 2, 0.5F}, {7, 9, 0}, {3, 7, 1}};
    surface.polygon_vertex = {0, 1, 2, 0, 2, 3};
    surface.polygon_offset = {0, 3, 6};
    surface.polygon_cell = {0, 1};
    return surface;
}

TEST(JoinedSurface, PointsOnOneMeshVertexBecomeOneInsideASurfaceOnly) {
    JoinedSurface joined;
    joined.add(touching(), {{"v", {1, 2, 3, 3}}});
    joined.add(touching(), {{"v", {4, 5, 6, 6}}});
    EXPECT_THAT(joined.surface().polygon_vertex, testing::ElementsAre(0, 1, 2, 0, 2, 2, 4, 5, 6, 4, 6, 6));
    EXPECT_THAT(joined.surface().polygon_offset, testing::ElementsAre(0, 3, 6, 9, 12));
    EXPECT_THAT(joined.values().at(0).values, testing::ElementsAre(1, 2, 3, 3, 4, 5, 6, 6));
    const ExportedPolygons polygons = exported_polygons(joined.surface(), false);
    EXPECT_THAT(polygons.vertices, testing::ElementsAre(0, 1, 2, 4, 5, 6));
    EXPECT_THAT(polygons.corner, testing::ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(JoinedSurface, NormalsAndValuesStayOnlyWhereAllHaveThem) {
    Surface plain = touching();
    plain.normals.clear();
    for (const bool plain_first : {false, true}) {
        JoinedSurface joined;
        joined.add(plain_first ? plain : touching(), {{"both", {1, 1, 1, 1}}, {"one", {2, 2, 2, 2}}});
        joined.add(plain_first ? touching() : plain, {{"both", {3, 3, 3, 3}}});
        EXPECT_TRUE(joined.surface().normals.empty());
        ASSERT_EQ(joined.values().size(), 1U);
        EXPECT_EQ(joined.values()[0].name, "both");
        EXPECT_EQ(joined.values()[0].values.size(), joined.surface().positions.size());
    }
    JoinedSurface with_empty;
    with_empty.add(Surface{}, {});
    with_empty.add(touching(), {});
    EXPECT_EQ(with_empty.surface().normals.size(), 4U);
}

TEST(SurfaceFiles, TheBodyIsKnownBeforeTheFileIsMade) {
    constexpr std::size_t largest_head = 2000;
    for (const SurfaceFormat format : {SurfaceFormat::ply, SurfaceFormat::stl, SurfaceFormat::vtp})
        for (const bool triangles : {false, true}) {
            JoinedSurface joined;
            for (int i = 0; i < 100; ++i) joined.add(touching(), {{"v", {1, 2, 3, 3}}, {"w", {4, 5, 6, 6}}});
            const ExportSurface surface{joined.surface(), {}, joined.values(), triangles};
            std::ostringstream file;
            write_surface(format, surface, file);
            const std::size_t head = file.str().size() - body_bytes(format, surface);
            EXPECT_LT(head, largest_head) << "also when it would be negative";
        }
}

} // namespace
} // namespace server::wire
