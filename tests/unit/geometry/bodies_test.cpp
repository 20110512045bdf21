#include "geometry/bodies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::geometry {
namespace {

const BoundingBox domain{{-5, -4, 0}, {15, 4, 8}};

MeasuredPatch patch(const std::string& name, const BoundingBox& box, double area, std::size_t faces,
                    const std::string& type = {}) {
    return {name, box, area, faces, type};
}

std::vector<std::string> chosen(const std::vector<MeasuredPatch>& patches, const BoundingBox& of = domain) {
    std::vector<std::string> names;
    for (const MeasuredPatch& body : bodies_of(patches, of)) names.push_back(body.name);
    return names;
}

// The sides of a wind tunnel.
const std::vector<MeasuredPatch> tunnel{
    patch("inlet", {{-5, -4, 0}, {-5, 4, 8}}, 64, 64), patch("outlet", {{15, -4, 0}, {15, 4, 8}}, 64, 64),
    patch("frontAndBack", {{-5, -4, 0}, {15, 4, 8}}, 320, 320), patch("upperWall", {{-5, -4, 8}, {15, 4, 8}}, 160, 160),
    patch("lowerWall", {{-5, -4, 0}, {15, 4, 0}}, 160, 5349)};

std::vector<MeasuredPatch> tunnel_with(const MeasuredPatch& further) {
    std::vector<MeasuredPatch> patches = tunnel;
    patches.push_back(further);
    return patches;
}

TEST(bodies, are_what_stands_in_the_tunnel_but_not_its_ground) {
    std::vector<MeasuredPatch> patches =
        tunnel_with(patch("motorBike_rr-wh-tyre", {{1, -0.1, 0}, {1.6, 0.1, 0.6}}, 0.5, 1864));
    patches.push_back(patch("motorBike_hbars", {{0.2, -0.3, 0.8}, {0.4, 0.3, 1}}, 0.1, 587));
    EXPECT_THAT(chosen(patches), testing::ElementsAre("motorBike_rr-wh-tyre", "motorBike_hbars"));
    const BoundingBox box = box_around(bodies_of(patches, domain));
    EXPECT_EQ(box, (BoundingBox{{0.2, -0.3, 0}, {1.6, 0.3, 1}}));
}

TEST(bodies, are_not_what_something_flows_through) {
    const BoundingBox inside{{0, -1, 1}, {1, 1, 2}};
    for (const char* name : {"engine_inlet", "Exhaust_Outlet", "AMI1", "ami_rotor_1", "cyclicHalf0", "farField"})
        EXPECT_THAT(chosen(tunnel_with(patch(name, inside, 1, 1000))), testing::IsEmpty()) << name;
    for (const char* name : {"dynamicWall", "Amiral", "back", "defaultFaces"})
        EXPECT_THAT(chosen(tunnel_with(patch(name, inside, 1, 1000))), testing::ElementsAre(name));
}

TEST(bodies, are_the_walls_where_the_solver_tells_types) {
    const BoundingBox inside{{0, -1, 1}, {1, 1, 2}};
    std::vector<MeasuredPatch> patches = tunnel;
    for (MeasuredPatch& side : patches) side.type = side.name == "lowerWall" ? "wall" : "patch";
    patches.push_back(patch("outletGuideVane", inside, 1, 1000, "wall")); // by its name it would be an outlet
    patches.push_back(patch("heatedInletPipe", inside, 1, 1000, "mappedWall"));
    patches.push_back(patch("obstacle", inside, 1, 1000, "patch")); // by its name it would be a body
    EXPECT_THAT(chosen(patches), testing::ElementsAre("outletGuideVane", "heatedInletPipe"));
}

TEST(bodies, reach_from_side_to_side) {
    EXPECT_THAT(chosen(tunnel_with(patch("wing", {{0, -4, 3}, {2, 4, 3.5}}, 33, 4000))), testing::ElementsAre("wing"));
}

TEST(bodies, that_touch_all_sides_have_finer_faces) {
    const BoundingBox all{{-5, -4, 0}, {15, 4, 2}};
    EXPECT_THAT(chosen(tunnel_with(patch("town", all, 200, 100'000))), testing::ElementsAre("town"));
    EXPECT_THAT(chosen(tunnel_with(patch("hills", all, 200, 250))), testing::IsEmpty());
}

TEST(bodies, are_not_the_walls_of_a_pipe) {
    const std::vector<MeasuredPatch> pipe{patch("in", {{0, 0, 0}, {0, 1, 1}}, 0.8, 100),
                                          patch("out", {{10, 0, 0}, {10, 1, 1}}, 0.8, 100),
                                          patch("wall", {{0, 0, 0}, {10, 1, 1}}, 31, 100'000)};
    EXPECT_THAT(chosen(pipe, {{0, 0, 0}, {10, 1, 1}}), testing::IsEmpty());
}

} // namespace
} // namespace server::geometry
