// How large interactive pictures are: as the view, of no more than 1280 x 720 pixels, and where those take so long that
// a drag would show a few a second (in software: much that is transparent, in volumes) half or a quarter as wide.
#pragma once

#include "geometry/view_size.hpp"

namespace ciel::frames {

// Not thread-safe.
class PreviewSize {
public:
    // So many of the view's pixels along a side are one.
    [[nodiscard]] double scale(geometry::ViewSize view) const;
    // What the last such picture of the view took.
    void took(geometry::ViewSize view, double milliseconds);

private:
    int halvings_ = 0, slow_ = 0; // slow ones in a row: the first of a kind waits for its programs
};

} // namespace ciel::frames
