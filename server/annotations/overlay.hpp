// A two-dimensional drawing over a picture. The layout (layout.hpp) makes this drawing, and the overlay painter of
// server/render draws it. Coordinates are in pixels from the upper left corner. Drawing order: plates, fills, strokes,
// triangles, labels.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace server::annotations {

using Ink = std::array<float, 4>; // RGB and opacity

struct PicturePoint { // also a direction in the picture
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

// Returns the part of the line inside the box as fractions, 0 at a and 1 at b, or nothing if it only touches the box.
[[nodiscard]] std::optional<std::pair<double, double>> part_inside(const Box& box, const PicturePoint& a,
                                                                   const PicturePoint& b);

// A background that keeps text readable on any picture. It fades out around the box.
struct Plate {
    Box box;
    double edge = 0; // width in pixels of the border in which the plate fades out
    Ink top{}, bottom{};
};
struct Fill { // a box with a vertical gradient
    Box box;
    Ink top{}, bottom{};
};
struct Stroke { // a line with soft edges
    PicturePoint from, to;
    double width = 1;
    Ink ink{};
};
struct Triangle {
    std::array<PicturePoint, 3> corners{};
    Ink ink{};
};
struct Label {
    std::string text;
    int pixels = 0;   // size of the font
    int x = 0, y = 0; // start of the base line
    Ink ink{};
    Box box; // around the text, with the font's full ascent and descent
};

// An area over which the page puts a text field or buttons. `id`: for example "legend 0 low".
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
    Ink halo{}; // color of the outline around letters and strokes, which makes them visible on any background
};

} // namespace server::annotations
