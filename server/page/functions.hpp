// What the page asks of the server's own code: the layout of annotations, and numbers as text. Each function
// reads its arguments from a message and appends its results to another, in the order of its comment.
#pragma once

#include "annotations/text_measure.hpp"
#include "page/message.hpp"

namespace ciel::page {

// Arguments: width, height (CSS pixels); text size (CSS pixels); camera: position (3), target (3), up (3), field of
// view (degrees), parallel (0 or 1), parallel height; bounds: low corner (3), high corner (3), in world coordinates;
// background: RGB at the top, RGB at the bottom (0 to 1); triad, axes (0 or 1); length units (text); number of taken
// boxes, then left, top, right and bottom of each. The layout keeps off the taken boxes.
// Results: the overlay of the triad, then that of the axes. An overlay has six lists, each after its length: plates
// (box, edge, ink), fills (box, ink at the top, ink at the bottom), strokes (from, to, width, ink), triangles (three
// corners, ink), labels (text, size, x and y of the base line's start, ink, box), handles (id, box); then the halo's
// ink. Ink: red, green, blue and opacity, 0 to 1. A plate has the ink of its middle. An unusable camera (see
// view_transform) has an empty layout.
void lay_out(Reader& arguments, annotations::TextMeasure& measure, Writer& results);

// Arguments: width, height (CSS pixels); text size (CSS pixels); background as above; title (text); captions: number,
// then each text; legends: number, then for each its name, its units (texts); a color scale, map (text), color points
// (number, then position and color of each), reverse (0 or 1), colors of missing values, below and above the range
// (each of the latter after 1, or only 0); the name of its layers (text); missing, both ends (0 or 1); more lines
// (number, then each text); width and height kept for controls. A color is red, green and blue, 0 to 255. Results: the
// overlay of title, captions and legends, then the taken boxes (number, then each).
void lay_texts(Reader& arguments, annotations::TextMeasure& measure, Writer& results);

// A color scale, above and below: lower end, upper end, log (0 or 1), steps.
// color scale -> exponent. See exponent_of.
void exponent_of(Reader& arguments, Writer& results);
// color scale, value -> text. See label_on.
void label_on(Reader& arguments, Writer& results);
// value, digits -> text. See number_label.
void number_alone(Reader& arguments, Writer& results);
// exponent -> text. See times_power_of_ten.
void times_power_of_ten(Reader& arguments, Writer& results);
// text -> text. See pretty_units.
void pretty_units(Reader& arguments, Writer& results);

} // namespace ciel::page
