// Test fields on vertices, and values at which to cut them.
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

[[nodiscard]] std::vector<float> random_field(std::size_t vertices, std::uint64_t seed); // values in [0, 1)
// Integers from 0 to levels - 1: neighboring values are often equal, and integer iso-values hit vertices.
[[nodiscard]] std::vector<float> tied_field(std::size_t vertices, int levels, std::uint64_t seed);
[[nodiscard]] std::vector<float> linear_field(const Polyhedra& mesh, const LinearField& field);
// A smooth field.
[[nodiscard]] std::vector<float> bumps_field(const Polyhedra& mesh, std::uint64_t seed);
// The bumps field, cut off at half its height: large regions of one value.
[[nodiscard]] std::vector<float> plateau_field(const Polyhedra& mesh, std::uint64_t seed);

struct NamedField {
    std::string name;
    std::vector<float> (*make)(const Polyhedra& mesh);
};
[[nodiscard]] const std::vector<NamedField>& all_fields();

// Sequence of values that rises, falls, jumps, leaves the range at both ends, repeats values and hits vertices.
[[nodiscard]] std::vector<double> walk_through(const std::vector<float>& values, int steps, std::uint64_t seed);

} // namespace ciel::test
