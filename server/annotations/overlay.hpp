// A flat drawing over a picture, in pixels from the upper left corner: output of the layout, input of the overlay
// painter. Drawing order: plates, fills, strokes, triangles, labels.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ciel::annotations {

using Ink = std::array<float, 4>; // RGB and opacity

struct Place {
    double x = 0, y = 0;
};

struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;

    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
    [[nodiscard]] bool overlaps(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    [[nodiscard]] bool holds(const Box& other) const {
        return left <= other.left && top <= other.top && right >= other.right && bottom >= other.bottom;
    }
};

// Returns the part of the line from a to b inside the box, as fractions from a to b; nothing if they only touch.
[[nodiscard]] std::optional<std::pair<double, double>> part_inside(const Box& box, const Place& a, const Place& b);

struct Plate { // keeps text readable on any picture; fades out around the box
    Box box;
    double edge = 0; // width of the fading, in pixels
    Ink top{}, bottom{};
};
struct Fill { // vertical gradient
    Box box;
    Ink top{}, bottom{};
};
struct Stroke { // a line with soft edges
    Place from, to;
    double width = 1;
    Ink ink{};
};
struct Triangle {
    std::array<Place, 3> corners{};
    Ink ink{};
};
struct Label {
    std::string text;
    int pixels = 0;   // size of the font
    int x = 0, y = 0; // start of the base line
    Ink ink{};
    Box box; // around the text, with the font's full ascent and descent
};

// A place of the drawing where the page puts a field or buttons. `id`: what stands there, such as "legend 0 low".
struct Handle {
    std::string id;
    Box box;
};

struct Overlay {
    std::vector<Plate> plates;
    std::vector<Fill> fills;
    std::vector<Stroke> strokes;
    std::vector<Triangle> triangles;
    std::vector<Label> labels;
    std::vector<Handle> handles;
    Ink halo{}; // outline of letters and strokes, visible on any background
};

} // namespace ciel::annotations
