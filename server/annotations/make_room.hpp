// Moves a camera so that annotations do not cover the scene.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/text_measure.hpp"

namespace ciel::annotations {

// Returns the picture's camera, moved back from its target until no edge of the bounds lies under a legend, a caption
// or the triad, and the numbers of the axes fit. If the camera would move too far away, as in a narrow picture, camera
// and target also move right or up. If that fails, the camera is returned unchanged.
// The result is the same for all sizes of one aspect ratio, except sizes so small that text has its smallest size.
// Throws Error when there is no font.
[[nodiscard]] Camera clear_of_annotations(const AnnotatedPicture& picture, TextMeasure& text);

} // namespace ciel::annotations
