#include "geometry/drawing_origin.hpp"

#include <gtest/gtest.h>

namespace server::geometry {
using namespace ciel;
namespace {

constexpr Vec3d middle{50, 50, 50}, wall{50, 50, 0}, beside{50, 50.001, 0};

annotations::ViewCamera looking_at(const Vec3d& target, double distance) {
    return {{target[0], target[1] - distance, target[2]}, target, {0, 0, 1}, 30, false, 1};
}

TEST(drawing_origin, is_the_middle_while_floats_are_fine_enough) {
    for (const double distance : {1e6, 100.0, 1.0}) {
        EXPECT_EQ(drawing_origin(middle, wall, looking_at(middle, distance)), middle);
        EXPECT_EQ(drawing_origin(middle, wall, looking_at(wall, distance)), middle);
    }
    EXPECT_EQ(drawing_origin(middle, {}, looking_at(middle, 1e-9)), middle);
}

TEST(drawing_origin, is_the_target_of_a_camera_that_is_close) {
    EXPECT_EQ(drawing_origin(middle, {}, looking_at(wall, 1e-3)), wall);
    annotations::ViewCamera parallel = looking_at(wall, 100);
    parallel.parallel = true;
    parallel.parallel_height = 1e-3;
    EXPECT_EQ(drawing_origin(middle, {}, parallel), wall);
    parallel.parallel_height = 100;
    EXPECT_EQ(drawing_origin(middle, {}, parallel), middle);
}

TEST(drawing_origin, stays_while_the_camera_moves_near_it) {
    EXPECT_EQ(drawing_origin(middle, wall, looking_at(beside, 1e-3)), wall);
    EXPECT_EQ(drawing_origin(middle, wall, looking_at(beside, 1e-6)), beside) << "the last one is too far";
}

TEST(drawing_origin, of_a_camera_without_a_distance_is_its_target) {
    EXPECT_EQ(drawing_origin(middle, {}, looking_at(wall, 0)), wall);
}

} // namespace
} // namespace server::geometry
