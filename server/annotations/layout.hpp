// One picture's sheet while its annotations are laid out: how large things are, what is taken, and what is drawn.
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
    // Sizes follow the picture: text of 13 pixels where it has 720 rows, never less than 9.
    Layout(const AnnotatedPicture& picture, TextMeasure& measure);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] double em() const { return text_.pixels; }
    [[nodiscard]] double stroke_width() const { return em() / 10; }
    [[nodiscard]] const TextSize& text() const { return text_; }
    [[nodiscard]] bool has_smallest_text() const; // else it grows and shrinks with the picture
    [[nodiscard]] const TextSize& heading() const { return heading_; }
    [[nodiscard]] const Ink& ink() const { return ink_; }
    // What is not yet given to something that fills a side: everything within the margins at first.
    Box room;

    [[nodiscard]] int width_of(const std::string& text, const TextSize& size);
    // The text, or as much of its start as fits with an ellipsis; empty where nothing does.
    [[nodiscard]] std::string shortened(const std::string& text, const TextSize& size, double most_width);
    // Around text whose base line starts at (x, y).
    [[nodiscard]] Box box_of(const std::string& text, const TextSize& size, int x, int y);
    void write(const std::string& text, const TextSize& size, int x, int y, const Ink& ink);
    // A plate behind what is written in the box.
    void back(const Box& box);
    void write_backed(const std::string& text, const TextSize& size, int x, int y); // in `ink()`, with its plate

    // Whether the box lies in the picture and on nothing that was taken.
    [[nodiscard]] bool is_free(const Box& box) const;
    void take(const Box& box) { taken_.push_back(box); }
    // Draws and takes those parts of a line that lie on no box that was taken.
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

// Each draws its part of picture.annotations where there is room for it, and nothing on anything that was drawn before.
// In this order: what comes later gives way. Of captions the last are left out first, of legends likewise, which is
// said, and all of those that would begin in the left third; the triad as a whole; of axes single numbers and names,
// and parts of lines.
void lay_title(Layout& layout, const Annotations& annotations);
void lay_captions(Layout& layout, const Annotations& annotations);
void lay_legends(Layout& layout, const Annotations& annotations);
void lay_triad(Layout& layout, const AnnotatedPicture& picture);
void lay_axes(Layout& layout, const AnnotatedPicture& picture);

// All of them.
[[nodiscard]] Overlay lay_out(const AnnotatedPicture& picture, TextMeasure& measure);

} // namespace ciel::annotations
