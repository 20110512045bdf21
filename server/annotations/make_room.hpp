// A view that leaves room for what is written beside it.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/text_measure.hpp"

namespace ciel::annotations {

// The picture's camera, moved back from its target until no edge of the bounds lies under a legend, a caption or the
// triad, and the numbers of the axes fit into the picture. Where that would take the box too far away, as in a narrow
// picture, it and its target are moved to the right as well, and where that is not enough it is as it was. The
// same for all sizes of one shape, but for those so small that their text, which has to be read, takes a larger share
// of them. Throws Error as the drawing of annotations does.
[[nodiscard]] Camera clear_of_annotations(const AnnotatedPicture& picture, TextMeasure& text);

} // namespace ciel::annotations
