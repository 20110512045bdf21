// What the page asks of the server's own code: the layout of axes and triad, ticks, and numbers as text. Each function
// reads its arguments from a message and appends its results to another, in the order of its comment.
#pragma once

#include "annotations/text_measure.hpp"
#include "page/message.hpp"

namespace ciel::page {

// Arguments: width, height (CSS pixels); text size (CSS pixels); camera: position (3), target (3), up (3), field of
// view (degrees), parallel (0 or 1), parallel height; bounds: low corner (3), high corner (3), in world coordinates;
// background: RGB at the top, RGB at the bottom (0 to 1); triad, axes (0 or 1); length units (text); number of taken
// boxes, then left, top, right and bottom of each. The layout keeps off the taken boxes.
// Results: the overlay of the triad, then that of the axes. An overlay has four lists, each after its length: plates
// (box, edge, ink), strokes (from, to, width, ink), triangles (three corners, ink), labels (text, size, x and y of the
// base line's start, ink, box); then the halo's ink. Ink: red, green, blue and opacity, 0 to 1. A plate has the ink of
// its middle.
// An unusable camera (see view_transform) has an empty layout.
void lay_out(Reader& arguments, annotations::TextMeasure& measure, Writer& results);

// A color scale, below: lower end, upper end, log (0 or 1), steps.
// color scale, most ticks, most marks -> number of ticks, then value, position and label (text) of each. See
// color_ticks.
void color_ticks(Reader& arguments, Writer& results);
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
