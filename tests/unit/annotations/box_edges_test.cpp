// Which edges of the bounding box get tick numbers, for several views.
#include "annotated_frames.hpp"
#include "annotations/box_edges.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace server::annotations {
using namespace server::render;
using namespace ciel;
namespace {

Frame view_from(Vec3d position, bool parallel = false) {
    Frame frame = front_view(800, 600);
    frame.camera.position = position;
    frame.camera.parallel = parallel;
    frame.camera.parallel_height = 4;
    return frame;
}

const annotations::BoxEdge* along(const std::vector<annotations::BoxEdge>& edges, int axis) {
    const auto found =
        std::find_if(edges.begin(), edges.end(), [&](const annotations::BoxEdge& e) { return e.axis == axis; });
    return found == edges.end() ? nullptr : &*found;
}

// The camera is in front, to the right and above: x along the front's bottom edge, y at the lower right, z at the left.
TEST(BoxEdges, OfACornerViewAreTheLowerAndTheLeftOnes) {
    for (const bool parallel : {false, true}) {
        const auto edges = annotations::axis_edges(view_from({4, -8, 4}, parallel), 10);
        ASSERT_EQ(edges.size(), 3U);
        EXPECT_EQ(along(edges, 0)->low, glm::dvec3(-1, -1, -1));
        EXPECT_EQ(along(edges, 0)->high, glm::dvec3(1, -1, -1));
        EXPECT_EQ(along(edges, 1)->low, glm::dvec3(1, -1, -1));
        EXPECT_EQ(along(edges, 2)->low, glm::dvec3(-1, -1, -1));
        EXPECT_GT(along(edges, 0)->outward.y, 0.9) << "numbers of x stand below it";
        EXPECT_LT(along(edges, 2)->outward.x, -0.9) << "those of z to the left";
    }
}

TEST(BoxEdges, OfAFaceSeenFromTheFrontAreTwo) {
    for (const bool parallel : {false, true}) {
        const auto edges = annotations::axis_edges(view_from({0, -6, 0}, parallel), 10);
        ASSERT_EQ(edges.size(), 2U);
        EXPECT_EQ(along(edges, 1), nullptr) << "y points at the viewer";
        EXPECT_EQ(along(edges, 0)->low.z, -1);
        EXPECT_EQ(along(edges, 2)->low.x, -1);
    }
}

TEST(BoxEdges, FromInsideAreNone) { EXPECT_TRUE(annotations::axis_edges(view_from({0, -0.5, 0.2}), 10).empty()); }

TEST(BoxEdges, ThatLeaveThePictureAreCutAtItsSides) {
    Frame frame = view_from({0, -6, 0}, true);
    frame.camera.target = {1, 0, -1}; // centers the lower right corner
    frame.camera.position = {1, -6, -1};
    frame.camera.parallel_height = 1;
    const auto edges = annotations::axis_edges(frame, 10);
    const annotations::BoxEdge* x = along(edges, 0);
    ASSERT_NE(x, nullptr);
    EXPECT_NEAR(x->from, 1 - 0.5 * (4.0 / 3) / 2, 1e-9);
    EXPECT_EQ(x->to, 1);
    EXPECT_EQ(along(edges, 2)->low.x, 1) << "the left side is not in the picture";
}

TEST(BoxEdges, BehindTheEyeAreNone) {
    Frame frame = view_from({0, -6, 0});
    frame.camera.target = {0, -12, 0};
    EXPECT_TRUE(annotations::axis_edges(frame, 10).empty());
}

TEST(BoxEdges, ProjectFarFromTheOriginToTheSamePixels) {
    const Frame near_frame = view_from({4, -8, 4});
    Frame far_frame = near_frame;
    const Vec3d offset{500000, 4000000, 100};
    far_frame.origin = offset;
    far_frame.camera.target = offset;
    for (std::size_t k = 0; k < 3; ++k) {
        far_frame.camera.position[k] += offset[k];
        far_frame.bounds_min[k] += offset[k];
        far_frame.bounds_max[k] += offset[k];
    }
    const annotations::PicturePoint a = annotations::Projection(near_frame).pixel({1, 1, -1});
    const annotations::PicturePoint b = annotations::Projection(far_frame).pixel({500001, 4000001, 99});
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
}

} // namespace
} // namespace server::annotations
