// Dye: the concentration of a dye that the cylinder releases, in one plane, over one period. The method is
// semi-Lagrangian: R. Courant, E. Isaacson, M. Rees, Comm. Pure Appl. Math. 5, 243 (1952). Cubic interpolation with a
// limiter keeps the concentration within [0, 1]. After some periods, the dye is periodic, as the flow is.
#pragma once

#include <array>
#include <vector>

namespace server::demo {

class Dye {
public:
    struct Extent {
        double x_low, x_high, y_low, y_high;
    };
    explicit Dye(Extent extent);

    // Returns a number from 0 to 1. time: in periods. (u, v): velocity of the flow at (x, y) and `time`. Thread-safe.
    [[nodiscard]] float at(double x, double y, double u, double v, double time) const;

private:
    [[nodiscard]] std::array<float, 2> node(std::size_t index) const;
    [[nodiscard]] float sample(const std::vector<float>& plane, double x, double y) const;
    void step(const std::vector<std::array<float, 2>>& departure, const std::vector<float>& from,
              std::vector<float>& to) const;
    void spread(const std::vector<float>& from, std::vector<float>& to) const; // one pass of diffusion

    Extent extent_;
    std::size_t nx_, ny_;
    std::vector<std::vector<float>> planes_; // for each phase: the concentration at each node
};

} // namespace server::demo
