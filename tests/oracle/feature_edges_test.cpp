// Feature edges of known surfaces: sharp bends, borders and branches.
#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "ciel/threshold_surface.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

Surface boundary(const Polyhedra& input) {
    const KernelMesh mesh(input);
    return threshold_surface(mesh.mesh(), std::vector<std::uint8_t>(mesh.mesh().cell_count(), 1));
}

TEST(FeatureEdges, OfABoxAreItsTwelveSides) {
    for (const Polyhedra& input : {hexahedra({{3, 4, 5}}), tetrahedra({{3, 4, 5}}), zoo({{3, 4, 5}, 0, 5, 1})}) {
        const Surface surface = boundary(input);
        EXPECT_EQ(feature_edges(surface, 30).size(), 2 * 4 * (3 + 4 + 5));
        EXPECT_EQ(feature_edges(surface, 0).size(), 2 * 4 * (3 + 4 + 5)) << "flat sides do not bend by rounding";
        EXPECT_TRUE(feature_edges(surface, 91).empty());
    }
}

TEST(FeatureEdges, EndsAndBranchesAreFeaturesAtAnyAngle) {
    Surface open; // three triangles at one edge
    open.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    open.polygon_vertex = {0, 1, 2, 1, 0, 3, 0, 1, 4};
    open.polygon_offset = {0, 3, 6, 9};
    open.polygon_cell = {0, 1, 2};
    EXPECT_EQ(feature_edges(open, 180), polygon_edges(open)) << "six ends and the edge of three";
    open.polygon_vertex.resize(6);
    open.polygon_offset.pop_back();
    open.polygon_cell.pop_back();
    EXPECT_EQ(feature_edges(open, 180).size(), polygon_edges(open).size() - 2) << "of two in one plane: no feature";
}

// Twelve prisms around an axis: 30 degrees between neighboring sides, 90 degrees at top and bottom.
TEST(FeatureEdges, TheAngleDecides) {
    const Surface surface = boundary(o_grid(2, 12, 1));
    const std::size_t sharp = feature_edges(surface, 45).size(), fine = feature_edges(surface, 20).size();
    EXPECT_EQ(sharp, 2 * 24U);
    EXPECT_EQ(fine, 2 * (24U + 12U));
}

} // namespace
} // namespace ciel::test
