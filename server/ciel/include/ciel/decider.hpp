// How the points on an ambiguous face are joined (paper, section 4). The decision uses only the face's own values, so
// both cells of a face decide alike and the surface is closed.
//
// The asymptotic decider is that of G. M. Nielson and B. Hamann, "The asymptotic decider: resolving the ambiguity in
// marching cubes", IEEE Visualization 1991: the high corners of a quadrangle are joined where the bilinear
// interpolation is high at its saddle. A face of more corners has no such interpolation; there the mean of its corners
// decides.
#pragma once

namespace ciel {

enum class Decider {
    isolate_high, // each high run of the face is cut off by itself
    asymptotic
};

} // namespace ciel
