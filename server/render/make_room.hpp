// A view that leaves room for what is written beside it.
#pragma once

#include "render/renderer.hpp"

namespace ciel::render {

// The frame's camera, moved back from its target until no edge of the bounds lies under a legend, a caption or the
// triad, and the numbers of the axes fit into the picture. As it is where that would take the box too far away. The
// same for all sizes of one shape. Throws Error as the drawing of annotations does.
[[nodiscard]] Camera clear_of_annotations(const Frame& frame);

} // namespace ciel::render
