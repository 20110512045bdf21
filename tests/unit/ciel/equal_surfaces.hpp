// Compares two surfaces bit by bit, with the order of their points and polygons.
#pragma once

#include "ciel/extract.hpp"

#include <gtest/gtest.h>

namespace ciel::test {

inline void expect_equal(const Surface& a, const Surface& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
    EXPECT_EQ(a.polygon_offset, b.polygon_offset);
    EXPECT_EQ(a.polygon_vertex, b.polygon_vertex);
    EXPECT_EQ(a.polygon_cell, b.polygon_cell);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i)
        ASSERT_TRUE(a.points[i].a == b.points[i].a && a.points[i].b == b.points[i].b && a.points[i].t == b.points[i].t);
}

} // namespace ciel::test
