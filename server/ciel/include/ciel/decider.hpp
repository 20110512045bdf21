// Decider: how the points of an iso-surface on an ambiguous face are joined (paper, section 4). A corner is high when
// its value >= the iso-value. A face is ambiguous if its loop has several runs of high corners. The decision uses only
// the values at the corners of the face. Therefore both cells of the face decide in the same way, and the surface is
// closed.
//
// Decider::asymptotic follows G. M. Nielson and B. Hamann, "The asymptotic decider: resolving the ambiguity in marching
// cubes", IEEE Visualization 1991: the high corners of a quadrangle are joined if the bilinear interpolation is high at
// its saddle point. A face with more corners has no bilinear interpolation. There the high corners are joined if the
// mean of all corner values is high.
#pragma once

namespace ciel {

enum class Decider {
    isolate_high, // never joins high corners: separates each run of high corners from the others
    asymptotic
};

} // namespace ciel
