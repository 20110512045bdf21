// Visible difference of two pictures. Colors are compared in CIE L*a*b* (D65), where a distance of 2 is just visible
// side by side.
// shift: largest change of a 16 x 16 tile's mean color. Detects faint changes over an area, such as another opacity or
// light. Differences of drivers at edges average out.
// share: part of the pixels whose color does not occur in the 3 x 3 pixels around their place in the other picture, in
// both directions. Detects things that moved, vanished or appeared. Edges may move by one pixel.
#pragma once

#include "support/golden/picture.hpp"

#include <string>

namespace ciel::test {

struct Difference {
    double shift = 0;
    int shift_x = 0, shift_y = 0; // upper left pixel of the tile with the largest change
    double share = 0;
};

struct Tolerance {
    double shift = 0.5;
    double share = 0.0005;
    static constexpr double color = 10; // pixels with a larger distance than this count for `share`
};

// Throws std::invalid_argument when the sizes differ.
[[nodiscard]] Difference difference(const Picture& a, const Picture& b);
[[nodiscard]] bool is_within(const Difference& difference, const Tolerance& tolerance);
// Gray where the pictures agree, red where they differ. A distance of 1 in L*a*b* is 25 of 255.
[[nodiscard]] Picture difference_picture(const Picture& a, const Picture& b);
[[nodiscard]] std::string words(const Difference& difference, const Tolerance& tolerance);

} // namespace ciel::test
