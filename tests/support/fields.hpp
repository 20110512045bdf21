// Test fields on vertices, with the values at which to cut them.
#pragma once

#include "support/polyhedra.hpp"

#include <string>

namespace ciel::test {

struct LinearField {
    std::array<double, 3> gradient;
    double constant = 0;
    [[nodiscard]] double at(const Point& p) const {
        return gradient[0] * p[0] + gradient[1] * p[1] + gradient[2] * p[2] + constant;
    }
};

[[nodiscard]] std::vector<float> random_field(std::size_t vertices, std::uint64_t seed); // in [0, 1)
// Few distinct integers 0 .. levels - 1: neighbours tie, and every integer value hits vertices exactly.
[[nodiscard]] std::vector<float> tied_field(std::size_t vertices, int levels, std::uint64_t seed);
[[nodiscard]] std::vector<float> linear_field(const Polyhedra& mesh, const LinearField& field);
[[nodiscard]] std::vector<float> bumps_field(const Polyhedra& mesh,
                                             std::uint64_t seed); // smooth, over the mesh's bounds
// Bumps cut off at half their height: wide regions of exactly one value.
[[nodiscard]] std::vector<float> plateau_field(const Polyhedra& mesh, std::uint64_t seed);

struct NamedField {
    std::string name;
    std::vector<float> (*make)(const Polyhedra& mesh);
};
[[nodiscard]] const std::vector<NamedField>& all_fields();

// A walk that steps up, steps down, jumps, leaves the range at both ends, repeats itself and hits vertices exactly.
[[nodiscard]] std::vector<double> walk_through(const std::vector<float>& values, int steps, std::uint64_t seed);

} // namespace ciel::test
