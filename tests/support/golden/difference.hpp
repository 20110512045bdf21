// How different two pictures look. Colors are compared in CIE L*a*b* (D65), where a distance of about 2 is what an eye
// notices side by side. Two measures, because pictures go wrong in two ways and drivers differ in a third:
//   shift: the largest change of the mean color of a 16 x 16 tile. Finds what is faint and wide, such as an opacity or
//          a light that changed; where two drivers put an edge's samples differently averages out.
//   share: the part of the pixels whose color is found nowhere among the nine pixels around its place in the other
//          picture, either way. Finds what moved, vanished or appeared; an edge may be a pixel off.
#pragma once

#include "support/golden/picture.hpp"

#include <string>

namespace ciel::test {

struct Difference {
    double shift = 0;
    int shift_x = 0, shift_y = 0; // the tile's upper left pixel
    double share = 0;
};

struct Tolerance {
    double shift = 0.5;
    double share = 0.0005;
    static constexpr double color = 10; // further apart than this, pixels count for `share`
};

// Of the same size. Throws std::invalid_argument else.
[[nodiscard]] Difference difference(const Picture& a, const Picture& b);
[[nodiscard]] bool is_within(const Difference& difference, const Tolerance& tolerance);
// Grey where the pictures agree, red where they do not: 1 of L*a*b* is 25 of 255.
[[nodiscard]] Picture difference_picture(const Picture& a, const Picture& b);
[[nodiscard]] std::string words(const Difference& difference, const Tolerance& tolerance);

} // namespace ciel::test
