// Flow: an unsteady flow past a cylinder in closed form.
// Based on: C. Jung, T. Tel, E. Ziemniak, "Application of scattering chaos to particle transport in a hydrodynamical
// flow", Chaos 3, 555 (1993): the stream function
//   Psi(x, y, t) = f(x, y) g(x, y, t)
//   f = 1 - exp(-a (r - 1)^2)                           no slip at r = 1
//   g = u0 y s(x, y) + sum of vortices                  s = 1 - exp(-((x - 1) / alpha)^2 - y^2) shields the wake
//   vortex: -+ w h exp(-kappa ((x - x_i)^2 + (y -+ y0)^2)), upper and lower in turn, half a period apart, born behind
//   the cylinder, moving downstream at a constant speed and gaining and losing strength as h = sin(pi age / life).
// Lengths are cylinder radii, times shedding periods. Departures from the paper: vortices are round, live two periods
// and travel 16 radii (in the paper: one pair, 2 radii), so several exist at a time. u0 = 10 is a Strouhal number of
// 0.2.
// A phase that varies along the span makes the flow three-dimensional and leaves it free of divergence.
#pragma once

#include <array>
#include <vector>

namespace ciel::demo {

struct FlowSample {
    double u = 0, v = 0; // velocity; the spanwise component is zero
    double vorticity = 0;
};

// The flow in one plane at one time.
class Flow {
public:
    explicit Flow(double time); // in periods
    [[nodiscard]] FlowSample at(double x, double y) const;

private:
    struct Vortex {
        double x, y, strength;
    };
    std::vector<Vortex> vortices_;
};

// Returns the time, in periods, by which the flow at height z is ahead of that at z = 0. span: length of the cylinder.
[[nodiscard]] double span_phase(double z, double span);

} // namespace ciel::demo
