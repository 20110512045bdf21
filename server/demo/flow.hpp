// Flow: an unsteady flow past a cylinder in closed form.
// Based on: C. Jung, T. Tel, E. Ziemniak, "Application of scattering chaos to particle transport in a hydrodynamical
// flow", Chaos 3, 555 (1993). The stream function is
//   Psi(x, y, t) = f(x, y) g(x, y, t)
//   f = 1 - exp(-a (r - 1)^2)                           no slip at r = 1
//   g = u0 y s(x, y) + sum of vortices                  s = 1 - exp(-((x - 1) / alpha)^2 - y^2): slow flow in the wake
//   vortex: -+ w h exp(-kappa ((x - x_i)^2 + (y -+ y0)^2))
// A vortex starts behind the cylinder every half period, in the upper and the lower row in turn. It moves downstream at
// a constant speed, and its strength changes as h = sin(pi age / life).
// The unit of length is the radius of the cylinder. The unit of time is the shedding period.
// Differences from the paper: vortices are round, live two periods and travel 16 radii, so that several vortices exist
// at a time. In the paper there is one pair, and vortices travel 2 radii.
// u0 = 10 means a Strouhal number of 0.2.
// A phase that varies along the span makes the flow three-dimensional. The flow remains free of divergence.
#pragma once

#include <array>
#include <vector>

namespace server::demo {

struct FlowSample {
    double u = 0, v = 0; // velocity; the spanwise component is zero
    double vorticity = 0;
};

// The flow in one plane at one time.
class Flow {
public:
    explicit Flow(double time); // time in periods
    [[nodiscard]] FlowSample at(double x, double y) const;

private:
    struct Vortex {
        double x, y, strength;
    };
    std::vector<Vortex> vortices_;
};

// Returns the time in periods by which the flow at height z is ahead of the flow at z = 0.
[[nodiscard]] double span_phase(double z, double span);

} // namespace server::demo
