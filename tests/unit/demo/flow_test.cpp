// The closed form of the flow against properties of any flow past a cylinder.
#include "demo/dye.hpp"
#include "demo/flow.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace server::demo {
namespace {

constexpr double step = 1e-5;

class FlowAt : public testing::TestWithParam<double> {};

TEST_P(FlowAt, IsFreeOfDivergenceAndItsVorticityIsItsCurl) {
    const Flow flow(GetParam());
    for (double x = -4; x < 14; x += 0.73)
        for (double y = -4; y < 4; y += 0.61) {
            if (std::hypot(x, y) < 1.01) continue;
            const FlowSample left = flow.at(x - step, y), right = flow.at(x + step, y), below = flow.at(x, y - step),
                             above = flow.at(x, y + step);
            EXPECT_NEAR((right.u - left.u + above.v - below.v) / (2 * step), 0, 1e-5) << x << ' ' << y;
            EXPECT_NEAR((right.v - left.v - above.u + below.u) / (2 * step), flow.at(x, y).vorticity, 1e-5)
                << x << ' ' << y;
        }
}

TEST_P(FlowAt, SticksToTheCylinderAndIsAFreeStreamFarOff) {
    const Flow flow(GetParam());
    for (int n = 0; n < 100; ++n) {
        const FlowSample wall = flow.at(std::cos(0.1 * n), std::sin(0.1 * n));
        EXPECT_NEAR(std::hypot(wall.u, wall.v), 0, 1e-12);
    }
    const FlowSample far = flow.at(-30, 3);
    EXPECT_NEAR(far.u, 10, 1e-9);
    EXPECT_NEAR(far.v, 0, 1e-9);
}

TEST_P(FlowAt, RepeatsAfterAPeriodAndMirrorsAfterHalfOfOne) {
    const Flow now(GetParam()), later(GetParam() + 1), half(GetParam() + 0.5);
    for (double x = -3; x < 14; x += 0.9) {
        EXPECT_NEAR(now.at(x, 1.3).u, later.at(x, 1.3).u, 1e-9);
        EXPECT_NEAR(now.at(x, 1.3).v, -half.at(x, -1.3).v, 1e-9);
        EXPECT_NEAR(now.at(x, 1.3).u, half.at(x, -1.3).u, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Times, FlowAt, testing::Values(-0.3, 0.0, 0.21, 0.5, 0.77, 1.0, 3.9));

TEST(DyeTest, IsFullAtTheWallNoneUpstreamAndRolledUpInTheWake) {
    const Dye dye({-5, 12, -4, 4});
    float wake = 0;
    for (double time = 0x1p-7; time < 1; time += 0.125) { // `time` and time + 1 are exact in binary
        EXPECT_EQ(dye.at(1, 0, 0, 0, time), 1);
        EXPECT_EQ(dye.at(-4, 0.3, 10, 0, time), 0);
        for (double x = 2; x < 10; x += 0.11)
            for (double y = -3; y < 3; y += 0.17) {
                const FlowSample flow = Flow(time).at(x, y);
                const float value = dye.at(x, y, flow.u, flow.v, time);
                ASSERT_GE(value, 0);
                ASSERT_LE(value, 1);
                EXPECT_EQ(value, dye.at(x, y, flow.u, flow.v, time + 1));
                if (x > 6) wake = std::max(wake, value);
            }
    }
    EXPECT_GT(wake, 0.5F);
}

} // namespace
} // namespace server::demo
