// The asymptotic decider on one ambiguous face (paper, section 4; decider.hpp).
#pragma once

#include <cstddef>

namespace ciel::detail {

// Returns whether the high corners of the face are joined. `n`: number of corners of the face. value(i): the value of
// corner i. REQUIRES: around the face, high and low change at least four times. In a quadrangle, the result does not
// depend on the first corner and the direction, so both cells of the face get the same result.
template <class Value>
[[nodiscard]] bool joins_high(std::size_t n, double nu, Value&& value) {
    if (n == 4) {
        const bool first_is_high = value(0) >= nu;
        const double a = value(first_is_high ? 0 : 1), c = value(first_is_high ? 2 : 3);
        const double b = value(first_is_high ? 1 : 0), d = value(first_is_high ? 3 : 2);
        return a * c - b * d >= nu * ((a + c) - (b + d)); // a and c are high, so that nu's factor is positive
    }
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += value(i);
    return sum >= nu * static_cast<double>(n);
}

} // namespace ciel::detail
