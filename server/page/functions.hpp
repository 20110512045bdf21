// Functions of the server that the page calls: the layout of annotations, the default camera, numbers as text,
// backgrounds, ranges of color scales and colors along them, color maps, and names of legends. Each function reads its
// arguments from one message and appends its results to another message, in the order that its comment gives.
#pragma once

#include "annotations/text_measure.hpp"
#include "page/message.hpp"

namespace server::page {

// Lays out the triad and the axes. They do not cover the taken boxes.
// Arguments: width, height (CSS pixels); text size (CSS pixels); camera: position (3), target (3), up (3), field of
// view (degrees), parallel (0 or 1), parallel height; bounds: low corner (3), high corner (3), in world coordinates;
// background: RGB at the top, RGB at the bottom (0 to 1); triad, axes (0 or 1); length units (text); number of taken
// boxes, then left, top, right and bottom of each box.
// Results: the overlay of the triad, then the overlay of the axes. An overlay has six lists, each after its length:
// plates (box, edge, ink), fills (box, ink at the top, ink at the bottom), strokes (from, to, width, ink), triangles
// (three corners, ink), labels (text, size, x and y of the start of the base line, ink, box), handles (id, box). The
// ink of the halo follows. An ink has red, green, blue and opacity, 0 to 1. The ink of a plate is the mean of its inks
// at the top and at the bottom. For an unusable camera (see view_transform), both overlays are empty.
void lay_out(Reader& arguments, annotations::TextMeasure& measure, Writer& results);

// Lays out the title, the captions and the legends.
// Arguments: width, height (CSS pixels); text size (CSS pixels); background as in lay_out(); title (text); captions:
// number, then each text; legends: number, then each legend. A legend has: name, units (texts); a color scale (see
// below); name of its layers (text); missing, both ends (0 or 1); more lines (number, then each text); width and height
// of the room for controls.
// Results: the overlay of title, captions and legends, then the taken boxes (number, then each box).
void lay_texts(Reader& arguments, annotations::TextMeasure& measure, Writer& results);

// Low corner (3) and high corner (3) of a box in world coordinates, aspect ratio, field of view (degrees) -> position
// (3), target (3), up (3), parallel height (see annotations::default_camera)
void default_camera(Reader& arguments, Writer& results);

// A scale of values consists of: lower end, upper end, log (0 or 1), steps.
// A color scale consists of: a scale of values; map (text); color points (number, then position and color of each
// point); reverse (0 or 1); color of missing values; colors below and above the range (for each: 1 and the color, or
// only 0). A color is red, green and blue, 0 to 255.
// The comments of the functions below have the form: arguments -> results.
void label_on(Reader& arguments, Writer& results);     // scale of values, value -> text
void number_alone(Reader& arguments, Writer& results); // value, digits -> text
void pretty_units(Reader& arguments, Writer& results); // text -> text

void has_width(Reader& arguments, Writer& results);    // scale of values -> 0 or 1
void place_of(Reader& arguments, Writer& results);     // scale of values, value -> place
void value_at(Reader& arguments, Writer& results);     // scale of values, place -> value
void color_of(Reader& arguments, Writer& results);     // color scale, value -> color
void colors_along(Reader& arguments, Writer& results); // color scale, number of colors -> number of colors, each color
void color_row(Reader& arguments, Writer& results);    // color scale, number if smooth -> number of colors, each color
void scale_rules(Reader& arguments, Writer& results);  // color scale -> origin, texels (see color::ScaleRules)

// "light", or any other text for the dark background -> RGB at the top, RGB at the bottom (0 to 1)
void named_background(Reader& arguments, Writer& results);
void is_bright(Reader& arguments, Writer& results); // RGB at the top, RGB at the bottom (0 to 1) -> 0 or 1

// A choice of a range (see color::RangeChoice) consists of: the given range (1, lower end, upper end, or only 0),
// symmetric, log (0 or 1).
void range_of(Reader& arguments, Writer& results);         // choice, both ends of the data -> both ends
void range_above_zero(Reader& arguments, Writer& results); // both ends -> both ends
void is_shown_by(Reader& arguments, Writer& results);      // choice, both ends of the data -> 0 or 1

// Nothing -> number of color maps; for each: name, kind (texts, see color::NamedColors)
void color_maps(Reader& arguments, Writer& results);

// Scale of values, array, units -> text
void legend_title(Reader& arguments, Writer& results);
// Type of the layer (text), contours (0 or 1), array (text), origin (3), normal (3), number of patches, each patch (see
// annotations::NamedLayer) -> text
void legend_name_of(Reader& arguments, Writer& results);
// Number of legends; for each: array (text), number of names, each name -> number of legends, name of each legend
void legend_names(Reader& arguments, Writer& results);

} // namespace server::page
