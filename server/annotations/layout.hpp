// State of the layout of one picture's annotations: text sizes, occupied areas, and the resulting overlay.
#pragma once

#include "annotations/annotations.hpp"
#include "annotations/overlay.hpp"
#include "annotations/text_measure.hpp"

namespace server::annotations {

struct TextSize {
    int pixels = 0; // font size in pixels per em
    FontMetrics metrics;
    [[nodiscard]] int line() const { return metrics.ascent + metrics.descent; }
};

class Layout {
public:
    // The font size is 13 pixels in a picture of 1280 x 720 pixels. It scales with the picture, but is at least 9
    // pixels. Does not own `measure`, which must outlive the Layout.
    Layout(const AnnotatedPicture& picture, TextMeasure& measure);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double em() const { return text_.pixels; }
    [[nodiscard]] double stroke_width() const { return em() / 10; }
    [[nodiscard]] const TextSize& text() const { return text_; }
    // Returns whether the font size is at its lower limit, at which it no longer scales with the picture.
    [[nodiscard]] bool has_smallest_text() const;
    [[nodiscard]] const TextSize& heading() const { return heading_; }
    [[nodiscard]] const Ink& ink() const { return ink_; }
    // The area for annotations: the picture without its margins and without the title.
    Box room;

    [[nodiscard]] int width_of(const std::string& text, const TextSize& size);
    // If the text is too wide, returns the longest start that fits with an ellipsis, or an empty text if nothing fits.
    [[nodiscard]] std::string shortened(const std::string& text, const TextSize& size, double most_width);
    // Returns the box around text whose base line starts at pixel (x, y).
    [[nodiscard]] Box box_of(const std::string& text, const TextSize& size, int x, int y);
    void write(const std::string& text, const TextSize& size, int x, int y, const Ink& ink);
    // Draws a translucent plate behind the box, so that text in the box is readable.
    void back(const Box& box);
    void write_backed(const std::string& text, const TextSize& size, int x, int y);

    // Returns whether the box is inside the picture and overlaps no taken box or line.
    [[nodiscard]] bool is_free(const Box& box) const;
    void take(const Box& box) { taken_.push_back(box); }
    [[nodiscard]] const std::vector<Box>& taken() const { return taken_; }
    // Draws the parts of the line that are outside all taken boxes, and marks these parts as taken.
    void draw_line(const PicturePoint& from, const PicturePoint& to);

    Overlay overlay;

private:
    [[nodiscard]] Ink paper_at(double y) const;
    [[nodiscard]] std::vector<std::pair<PicturePoint, PicturePoint>> free_parts(const PicturePoint& from,
                                                                                const PicturePoint& to) const;

    TextMeasure& measure_;
    int width_, height_;
    TextSize text_, heading_;
    Ink ink_{};
    std::array<Ink, 2> paper_{}; // colors of plates at the top and at the bottom of the picture
    std::vector<Box> taken_;
    std::vector<std::pair<PicturePoint, PicturePoint>> lines_; // drawn lines; is_free() treats them like taken boxes
};

// Each of these functions lays out one kind of annotation, never over annotations that are already laid out. Call them
// in this order. Annotations that do not fit are left out: captions, the last legends, the triad, single numbers and
// names of axes, pieces of axis lines. If legends are left out, a note states how many, if there is room. No legend
// begins in the left third of the picture.
// They add these handles to the overlay: "legend i" around the whole legend i; "legend i low" and "legend i high"
// around the numbers at its ends, if there are two; "legend i controls" around the area for controls, if there is one.
void lay_title(Layout& layout, const Annotations& annotations);
void lay_captions(Layout& layout, const Annotations& annotations);
void lay_legends(Layout& layout, const Annotations& annotations);
void lay_triad(Layout& layout, const AnnotatedPicture& picture);
void lay_axes(Layout& layout, const AnnotatedPicture& picture);

[[nodiscard]] Overlay lay_out(const AnnotatedPicture& picture, TextMeasure& measure);

} // namespace server::annotations
