// The texels that shaders read. tests/unit/render/test_color_scale.cpp compares the colors of pictures with color_of().
#include "color/scale_rules.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace server::color {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

ColorScale scale_from(double low, double high, bool log = false) {
    ColorScale scale;
    scale.map = "grayscale";
    scale.range = {low, high};
    scale.log = log;
    return scale;
}

TEST(ScaleRules, AreLowFactorStepsAndWayThenLimitsThenColors) {
    ColorScale scale = scale_from(2, 6);
    scale.steps = 7;
    scale.above = Rgb8{255, 0, 51};
    scale.nan = {0, 255, 0};
    const ScaleRules rules = scale_rules(scale);
    EXPECT_EQ(rules.origin, 2);
    EXPECT_THAT(rules.texels[0], ElementsAre(0, 0.25F, 7, 0));
    EXPECT_NEAR(rules.texels[1][0], 0, 1e-5);
    EXPECT_NEAR(rules.texels[1][1], 4, 1e-5);
    EXPECT_THAT(rules.texels[2], ElementsAre(0, 0, 0, 1)) << "without a color below the range, that of the lower end";
    EXPECT_THAT(rules.texels[3], ElementsAre(1, 0, 0.2F, 1));
    EXPECT_THAT(rules.texels[4], ElementsAre(0, 1, 0, 1));
}

TEST(ScaleRules, OfLogarithmsAreToBaseTwo) {
    const ScaleRules above_zero = scale_rules(scale_from(2, 32, true));
    EXPECT_EQ(above_zero.origin, 0);
    EXPECT_THAT(above_zero.texels[0], ElementsAre(1, 0.25F, 0, 1));
    const ScaleRules both_signs = scale_rules(scale_from(-32, 32, true));
    const float reach = std::log2(1001.0F);
    EXPECT_THAT(both_signs.texels[0], ElementsAre(FloatEq(-reach), FloatEq(0.5F / reach), 0, FloatEq(-0.032F)));
}

TEST(ScaleRules, AreFiniteForAnyRange) {
    constexpr float largest = std::numeric_limits<float>::max();
    for (const bool log : {false, true})
        for (const auto& [low, high] : std::vector<std::pair<double, double>>{{-4e37, 4e37},
                                                                              {-1e-42, 1e-42},
                                                                              {-1e-36, 1e-36},
                                                                              {1e-37, 4e37},
                                                                              {5, 5},
                                                                              {0, 0},
                                                                              {1e9, 1e9 + 1e-3},
                                                                              {1e39, 1.1e39},
                                                                              {-1e308, 1e308}}) {
            if (log && low <= 0 && low != -high) continue;
            const ScaleRules rules = scale_rules(scale_from(low, high, log));
            for (const auto& texel : rules.texels)
                for (const float channel : texel) EXPECT_TRUE(std::isfinite(channel)) << low << ' ' << high;
        }
    EXPECT_THAT(scale_rules(scale_from(5, 5)).texels[1], ElementsAre(-largest, largest, 0, 0))
        << "all values are inside a range without width";
}

} // namespace
} // namespace server::color
