// How the points on an ambiguous face are joined (paper, section 4), from the face's own values: what two cells decide
// is the same, so the surface is closed either way.
//
// The asymptotic decider is that of G. M. Nielson and B. Hamann, "The asymptotic decider: resolving the ambiguity in
// marching cubes", IEEE Visualization 1991: the high corners of a quadrangle are joined where the bilinear
// interpolation is high at its saddle. A face of more corners has no such interpolation; there the mean of its corners
// decides.
#pragma once

namespace ciel {

enum class Decider {
    isolate_high, // the high side is cut off corner by corner
    asymptotic
};

} // namespace ciel
