// tests/unit/geometry/annotations_test.cpp tests the names of the layers of whole scenes (legend_cases.json).
#include "annotations/legend_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::annotations {
using namespace ciel;
namespace {

std::string name_of_slice(const Vec3d& origin, const Vec3d& normal, bool contours = false) {
    NamedLayer slice{"slice", contours};
    slice.origin = origin;
    slice.normal = normal;
    return legend_name_of(slice);
}

TEST(LegendNames, OfASliceTellItsPlane) {
    EXPECT_EQ(name_of_slice({1, 2.5, -3}, {0, -1, 0}), "Slice at y = 2.5");
    EXPECT_EQ(name_of_slice({1, 2.5, -3}, {0, 0, 1}, true), "Lines on slice at z = −3");
    EXPECT_EQ(name_of_slice({1, 2.5, -3}, {0, 0.8, 0.6}), "Free plane");
    EXPECT_EQ(name_of_slice({1, 2.5, -3}, {0, 0.8, 0.6}, true), "Lines on free plane");
}

TEST(LegendNames, ListTwoPatchesAtMost) {
    NamedLayer surface{"surface"};
    EXPECT_EQ(legend_name_of(surface), "Boundary");
    surface.groups = {"inlet", "outlet"};
    EXPECT_EQ(legend_name_of(surface), "Boundary: inlet, outlet");
    surface.groups = {"inlet", "outlet", "hull", "deck"};
    EXPECT_EQ(legend_name_of(surface), "Boundary: inlet, outlet and 2 more");
}

TEST(LegendNames, AreEmptyWhereNothingHasToBeToldApart) {
    EXPECT_EQ(legend_name_of({"outline"}), "");
    EXPECT_THAT(legend_names({{"p", {"Edges"}}, {"T", {"Edges"}}, {"p", {"Edges"}}, {"p", {"Points", "Points"}}}),
                testing::ElementsAre("Edges", "", "Edges (2)", "Points"));
}

TEST(LegendTitle, HasTheUnitsAndThePowerOfTen) {
    color::ColorScale scale;
    EXPECT_EQ(legend_title("p", "", scale), "p");
    EXPECT_EQ(legend_title("k", "m^2/s^2", scale), "k [m²/s²]");
    scale.range = {0, 1e9};
    EXPECT_EQ(legend_title("p", "Pa", scale), "p [Pa] ×10⁹");
    scale.log = true;
    EXPECT_EQ(legend_title("p", "Pa", scale), "p [Pa]");
}

} // namespace
} // namespace server::annotations
