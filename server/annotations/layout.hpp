// State of the layout of one picture's annotations: sizes, taken places, and the resulting overlay.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/overlay.hpp"
#include "annotations/text_measure.hpp"

namespace ciel::annotations {

struct TextSize {
    int pixels = 0; // of the font
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
    [[nodiscard]] bool has_smallest_text() const; // else text scales with the picture
    [[nodiscard]] const TextSize& heading() const { return heading_; }
    [[nodiscard]] const Ink& ink() const { return ink_; }
    // The area not yet given to annotations that fill a side; initially all within the margins.
    Box room;

    [[nodiscard]] int width_of(const std::string& text, const TextSize& size);
    // The text, or as much of its start as fits with an ellipsis; empty if nothing fits.
    [[nodiscard]] std::string shortened(const std::string& text, const TextSize& size, double most_width);
    // The box around text whose base line starts at (x, y).
    [[nodiscard]] Box box_of(const std::string& text, const TextSize& size, int x, int y);
    void write(const std::string& text, const TextSize& size, int x, int y, const Ink& ink);
    // Draws a plate behind the box.
    void back(const Box& box);
    void write_backed(const std::string& text, const TextSize& size, int x, int y); // in `ink()`, with its plate

    // Whether the box is inside the picture and overlaps no taken box or line.
    [[nodiscard]] bool is_free(const Box& box) const;
    void take(const Box& box) { taken_.push_back(box); }
    // Draws and takes the parts of a line outside all taken boxes.
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
    std::vector<std::pair<Place, Place>> lines_; // taken as well
};

// Each draws its part of picture.annotations where there is room, never over parts drawn before. Call in this order.
// Captions that do not fit are left out, the last first. Legends likewise, and a note says how many; none begins in the
// left third. The triad is left out as a whole, axes by single numbers, names and parts of lines.
void lay_title(Layout& layout, const Annotations& annotations);
void lay_captions(Layout& layout, const Annotations& annotations);
void lay_legends(Layout& layout, const Annotations& annotations);
void lay_triad(Layout& layout, const AnnotatedPicture& picture);
void lay_axes(Layout& layout, const AnnotatedPicture& picture);

// All of them.
[[nodiscard]] Overlay lay_out(const AnnotatedPicture& picture, TextMeasure& measure);

} // namespace ciel::annotations
