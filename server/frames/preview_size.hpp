// Size of interactive pictures: the size of the view, but at most 1280 x 720 pixels. If drawing takes more than 0.3 s
// (for example volumes or many transparent layers, drawn in software), width and height are divided by 2 or 4.
#pragma once

#include "geometry/view_size.hpp"

namespace server::frames {

// PreviewSize is not thread-safe.
class PreviewSize {
public:
    // Returns the side of an interactive picture as a fraction of the side of the view.
    [[nodiscard]] double scale(geometry::ViewSize view) const;
    void took(geometry::ViewSize view, double milliseconds);

private:
    int halvings_ = 0, slow_ = 0; // slow_: slow pictures in a row; a single picture may have waited for shaders
};

} // namespace server::frames
