// State of the layout of one picture's annotations: text sizes, taken places, and the resulting overlay.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/overlay.hpp"
#include "annotations/text_measure.hpp"

namespace ciel::annotations {

struct TextSize {
    int pixels = 0; // font size in pixels per em
    FontMetrics metrics;
    [[nodiscard]] int line() const { return metrics.ascent + metrics.descent; }
};

class Layout {
public:
    // Text has 13 pixels in a picture of 720 rows and scales with the picture, but has at least 9. Borrows `measure`.
    Layout(const AnnotatedPicture& picture, TextMeasure& measure);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double em() const { return text_.pixels; }
    [[nodiscard]] double stroke_width() const { return em() / 10; }
    [[nodiscard]] const TextSize& text() const { return text_; }
    [[nodiscard]] bool has_smallest_text() const; // if false, text scales with the picture
    [[nodiscard]] const TextSize& heading() const { return heading_; }
    [[nodiscard]] const Ink& ink() const { return ink_; }
    // The area that is free for annotations at the sides: the picture within its margins, below the title.
    Box room;

    [[nodiscard]] int width_of(const std::string& text, const TextSize& size);
    // Returns the text, or as much of its start as fits into most_width pixels with an ellipsis; empty if nothing fits.
    [[nodiscard]] std::string shortened(const std::string& text, const TextSize& size, double most_width);
    // Returns the box around text whose base line starts at pixel (x, y).
    [[nodiscard]] Box box_of(const std::string& text, const TextSize& size, int x, int y);
    void write(const std::string& text, const TextSize& size, int x, int y, const Ink& ink);
    // Draws a translucent plate behind the box, which keeps text readable.
    void back(const Box& box);
    void write_backed(const std::string& text, const TextSize& size, int x, int y); // in ink(), on a plate

    // Returns whether the box is inside the picture and overlaps no taken box or line.
    [[nodiscard]] bool is_free(const Box& box) const;
    void take(const Box& box) { taken_.push_back(box); }
    [[nodiscard]] const std::vector<Box>& taken() const { return taken_; }
    // Draws the parts of a line outside all taken boxes, and takes them.
    void draw_line(const Place& from, const Place& to);

    Overlay overlay;

private:
    [[nodiscard]] Ink paper_at(double y) const;
    [[nodiscard]] std::vector<std::pair<Place, Place>> free_parts(const Place& from, const Place& to) const;

    TextMeasure& measure_;
    int width_, height_;
    TextSize text_, heading_;
    Ink ink_{};
    std::array<Ink, 2> paper_{}; // the background at the top and the bottom of the picture
    std::vector<Box> taken_;
    std::vector<std::pair<Place, Place>> lines_; // drawn lines, which are taken places too
};

// Each of these functions draws one part of picture.annotations where there is room, never over parts drawn before.
// Call them in this order. Captions that do not fit are left out. Legends that do not fit are left out, the last ones
// first, and a note says how many; no legend begins in the left third of the picture. Legend i has the handles
// "legend i", around all of it, "legend i low" and "legend i high", around the numbers at its ends unless one number
// stands for both, and "legend i controls" if it keeps place for them. The triad is drawn whole or not
// at all. Of the axes, single numbers, names and parts of lines may be left out.
void lay_title(Layout& layout, const Annotations& annotations);
void lay_captions(Layout& layout, const Annotations& annotations);
void lay_legends(Layout& layout, const Annotations& annotations);
void lay_triad(Layout& layout, const AnnotatedPicture& picture);
void lay_axes(Layout& layout, const AnnotatedPicture& picture);

// Lays out all annotations of a picture.
[[nodiscard]] Overlay lay_out(const AnnotatedPicture& picture, TextMeasure& measure);

} // namespace ciel::annotations
