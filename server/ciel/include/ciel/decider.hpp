// Decider: how the points of an iso-surface on an ambiguous face are joined (paper, section 4). The decision uses only
// the values at the corners of the face, so both cells of a face decide alike and the surface is closed.
//
// Decider::asymptotic follows G. M. Nielson and B. Hamann, "The asymptotic decider: resolving the ambiguity in marching
// cubes", IEEE Visualization 1991: the high corners of a quadrangle are joined if the bilinear interpolation is high at
// its saddle point. A face with more corners has no bilinear interpolation; there the mean of the corner values
// decides.
#pragma once

namespace ciel {

enum class Decider {
    isolate_high, // never joins high corners: each run of high corners is cut off separately
    asymptotic
};

} // namespace ciel
