// What each decider says about one ambiguous face (paper, section 4; decider.hpp).
#pragma once

#include <cstddef>

namespace ciel {

// `value(i)` is that of the i-th of n corners around the face. The face is ambiguous at nu: high and low corners change
// places four times at least. The same for the two cells of a face, which may begin at another corner of a quadrangle
// or go round it the other way.
template <class Value>
[[nodiscard]] bool joins_high(std::size_t n, double nu, Value&& value) {
    if (n == 4) {
        const bool first_is_high = value(0) >= nu;
        const double a = value(first_is_high ? 0 : 1), c = value(first_is_high ? 2 : 3);
        const double b = value(first_is_high ? 1 : 0), d = value(first_is_high ? 3 : 2);
        return a * c - b * d >= nu * ((a + c) - (b + d)); // the last factor is positive: a and c are the high ones
    }
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += value(i);
    return sum >= nu * static_cast<double>(n);
}

} // namespace ciel
