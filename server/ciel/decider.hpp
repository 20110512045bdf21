// How the points on an ambiguous face are joined (paper, section 4), from the face's own values: what two cells decide
// is the same, so the surface is closed either way.
//
// The asymptotic decider is that of G. M. Nielson and B. Hamann, "The asymptotic decider: resolving the ambiguity in
// marching cubes", IEEE Visualization 1991: the high corners of a quadrangle are joined where the bilinear
// interpolation is high at its saddle. A face of more corners has no such interpolation; there the mean of its corners
// decides.
#pragma once

#include <cstddef>

namespace ciel {

enum class Decider {
    isolate_high, // the high side is cut off corner by corner
    asymptotic
};

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
