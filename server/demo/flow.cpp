#include "demo/flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace server::demo {
namespace {

constexpr double u0 = 10;        // speed of the free stream, in radii per period
constexpr double a = 1.5;        // 1 / (boundary layer thickness)^2
constexpr double alpha = 2;      // length of the slow region behind the cylinder, in radii
constexpr double w = 16;         // strength of the vortices
constexpr double kappa = 0.6;    // 1 / (vortex radius)^2
constexpr double y0 = 0.9;       // half the distance between the two rows of vortices, in radii
constexpr double life = 2;       // lifetime of a vortex, in periods
constexpr double travelled = 16; // distance that a vortex travels in its lifetime, in radii
constexpr double phase_swing = 0.14;

struct Jet {
    double value, dx, dy, laplacian;
};

Jet operator*(const Jet& f, const Jet& g) {
    return {f.value * g.value, f.value * g.dx + f.dx * g.value, f.value * g.dy + f.dy * g.value,
            f.value * g.laplacian + g.value * f.laplacian + 2 * (f.dx * g.dx + f.dy * g.dy)};
}

Jet operator+(const Jet& f, const Jet& g) {
    return {f.value + g.value, f.dx + g.dx, f.dy + g.dy, f.laplacian + g.laplacian};
}

Jet gaussian(double amplitude, double x, double y, double p, double q) {
    const double value = amplitude * std::exp(-(p * x * x + q * y * y));
    return {value, -2 * p * x * value, -2 * q * y * value, value * (4 * (p * p * x * x + q * q * y * y) - 2 * (p + q))};
}

Jet no_slip(double x, double y) {
    const double r = std::max(std::hypot(x, y), 1.0), d = r - 1, e = std::exp(-a * d * d);
    const double slope = 2 * a * d * e, curvature = 2 * a * e * (1 - 2 * a * d * d);
    return {1 - e, slope * x / r, slope * y / r, curvature + slope / r};
}

} // namespace

Flow::Flow(double time) {
    // Vortex n starts at time n / 2. Vortices with even n are in the upper row and turn clockwise.
    for (auto n = static_cast<long>(std::floor(2 * time)); n > 2 * (time - life); --n) {
        const double age = time - 0.5 * static_cast<double>(n);
        const double side = n % 2 == 0 ? 1 : -1;
        vortices_.push_back(
            {1 + travelled * age / life, side * y0, -side * w * std::sin(std::numbers::pi * age / life)});
    }
}

FlowSample Flow::at(double x, double y) const {
    const Jet shield = Jet{1, 0, 0, 0} + gaussian(-1, x - 1, y, 1 / (alpha * alpha), 1);
    Jet g = Jet{u0 * y, 0, u0, 0} * shield;
    for (const Vortex& vortex : vortices_) g = g + gaussian(vortex.strength, x - vortex.x, y - vortex.y, kappa, kappa);
    const Jet psi = no_slip(x, y) * g;
    return {psi.dy, -psi.dx, -psi.laplacian};
}

double span_phase(double z, double span) { return phase_swing * std::sin(2 * std::numbers::pi * z / span); }

} // namespace server::demo
