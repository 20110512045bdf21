// Moves a camera so that annotations do not cover the scene.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/text_measure.hpp"

namespace server::annotations {

// Returns the picture's camera, moved back until no edge of the bounding box is under an annotation. If twice the
// distance is not enough, as in a narrow picture, the camera and its target are also moved right or up. If this fails,
// too, the camera is unchanged. The result depends only on the aspect ratio, unless the text has its smallest size.
// Throws Error if there is no font.
[[nodiscard]] ViewCamera clear_of_annotations(const AnnotatedPicture& picture, TextMeasure& text);

} // namespace server::annotations
