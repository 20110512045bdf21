// Random cells for tests of gradients. Some are flat or stretched, have a corner without a value, or are of a size
// whose cube is outside the range of float32.
#pragma once

#include "fields/cell_gradient.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ciel::test {

class RandomCells {
public:
    void put_cell(std::size_t corners) {
        const double size = std::pow(10.0, below(7) == 0 ? static_cast<double>(below(60)) - 30 : 0);
        const double flat = below(5) == 0 ? 0 : std::pow(10.0, -static_cast<double>(below(12)));
        for (std::size_t c = 0; c < corners; ++c) {
            vertex.push_back(static_cast<std::uint16_t>(samples.size()));
            samples.push_back({size * share(), size * share(), size * flat * share(), share()});
        }
        if (below(9) == 0) samples.back().value = below(2) == 0 ? std::nan("") : INFINITY;
    }

    std::vector<detail::Sample> samples;
    std::vector<std::uint16_t> vertex; // for each cell, the indices of its corners in `samples`

private:
    std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }

    std::mt19937 random_{5};
};

} // namespace ciel::test
