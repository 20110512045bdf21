#include "annotations/layout.hpp"

#include "color/background.hpp"

#include <algorithm>
#include <cmath>

namespace server::annotations {
namespace {

constexpr double usual_height = 720;
constexpr double usual_text = 13, usual_heading = 18;
constexpr int smallest_text = 9, largest_text = 200;
constexpr Ink light{0.93F, 0.94F, 0.96F, 1}, dark{0.07F, 0.08F, 0.10F, 1};
constexpr float halo_opacity = 0.75F;
// Light text on a dark plate of this opacity has a contrast of at least 4.5 (WCAG 2.1, 1.4.3) even over white.
constexpr float plate_opacity = 0.72F;
constexpr double plate_edge = 0.3; // width in ems of the edge in which a plate fades out

TextSize size_of(double pixels, TextMeasure& measure) {
    const int rounded = std::clamp(static_cast<int>(std::lround(pixels)), smallest_text, largest_text);
    return {rounded, measure.metrics(rounded)};
}

double unit_of(const AnnotatedPicture& picture) {
    return size_of_picture(picture.width, picture.height) * picture.annotations.scale;
}

bool is_bright(const AnnotatedPicture& picture) {
    return color::is_bright({picture.background_top, picture.background_bottom});
}

Ink translucent(const std::array<float, 3>& color) { return {color[0], color[1], color[2], plate_opacity}; }

} // namespace

// The width limits the result, because legends that are sized by the height would fill a narrow picture.
double size_of_picture(int width, int height) { return std::min<double>(height, 0.75 * width) / usual_height; }

double scale_for_text(int width, int height, double pixels) {
    return pixels / (usual_text * size_of_picture(width, height));
}

Layout::Layout(const AnnotatedPicture& picture, TextMeasure& measure)
    : measure_(measure), width_(picture.width), height_(picture.height),
      text_(size_of(usual_text * unit_of(picture), measure)),
      heading_(size_of(usual_heading * unit_of(picture), measure)),
      ink_(is_bright(picture) ? dark : light), paper_{translucent(picture.background_top),
                                                      translucent(picture.background_bottom)} {
    overlay.halo = is_bright(picture) ? light : dark;
    overlay.halo[3] = halo_opacity;
    const double margin = std::round(em());
    room = {margin, margin, width_ - margin, height_ - margin};
}

bool Layout::has_smallest_text() const { return text_.pixels == smallest_text; }

int Layout::width_of(const std::string& text, const TextSize& size) { return measure_.width(text, size.pixels); }

std::string Layout::shortened(const std::string& text, const TextSize& size, double most_width) {
    if (width_of(text, size) <= most_width) return text;
    std::string start = text;
    while (!start.empty()) {
        while (start.size() > 1 && (static_cast<unsigned char>(start.back()) & 0xC0U) == 0x80) start.pop_back();
        start.pop_back();
        if (std::string candidate = start + "…"; !start.empty() && width_of(candidate, size) <= most_width)
            return candidate;
    }
    return {};
}

Box Layout::box_of(const std::string& text, const TextSize& size, int x, int y) {
    return {static_cast<double>(x), static_cast<double>(y - size.metrics.ascent),
            static_cast<double>(x + width_of(text, size)), static_cast<double>(y + size.metrics.descent)};
}

void Layout::write(const std::string& text, const TextSize& size, int x, int y, const Ink& ink) {
    overlay.labels.push_back({text, size.pixels, x, y, ink, box_of(text, size, x, y)});
}

Ink Layout::paper_at(double y) const {
    const auto share = static_cast<float>(std::clamp(y / height_, 0.0, 1.0));
    Ink ink{};
    for (std::size_t k = 0; k < ink.size(); ++k) ink[k] = paper_[0][k] + share * (paper_[1][k] - paper_[0][k]);
    return ink;
}

// The plate has the colors of the background, so that it is invisible over the background.
void Layout::back(const Box& box) {
    overlay.plates.push_back({box, plate_edge * em(), paper_at(box.top), paper_at(box.bottom)});
}

void Layout::write_backed(const std::string& text, const TextSize& size, int x, int y) {
    back(box_of(text, size, x, y));
    write(text, size, x, y, ink());
}

bool Layout::is_free(const Box& box) const {
    const Box all{0, 0, static_cast<double>(width_), static_cast<double>(height_)};
    const auto crosses = [&](const auto& line) { return part_inside(box, line.first, line.second).has_value(); };
    return all.holds(box) &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Box& b) { return b.overlaps(box); }) &&
           std::none_of(lines_.begin(), lines_.end(), crosses);
}

std::vector<std::pair<PicturePoint, PicturePoint>> Layout::free_parts(const PicturePoint& from,
                                                                      const PicturePoint& to) const {
    std::vector<std::pair<double, double>> hidden;
    for (const Box& box : taken_) {
        const double around = stroke_width();
        const Box wide{box.left - around, box.top - around, box.right + around, box.bottom + around};
        if (const auto part = part_inside(wide, from, to)) hidden.push_back(*part);
    }
    std::sort(hidden.begin(), hidden.end());
    hidden.emplace_back(1, 1);
    const auto at = [&](double share) {
        return PicturePoint{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
    };
    std::vector<std::pair<PicturePoint, PicturePoint>> parts;
    double start = 0;
    for (const auto& [first, last] : hidden) {
        if (first > start) parts.emplace_back(at(start), at(first));
        start = std::max(start, last);
    }
    return parts;
}

void Layout::draw_line(const PicturePoint& from, const PicturePoint& to) {
    for (const auto& part : free_parts(from, to)) {
        overlay.strokes.push_back({part.first, part.second, stroke_width(), ink_});
        lines_.push_back(part);
    }
}

Overlay lay_out(const AnnotatedPicture& picture, TextMeasure& measure) {
    Layout layout(picture, measure);
    lay_title(layout, picture.annotations);
    lay_captions(layout, picture.annotations);
    lay_legends(layout, picture.annotations);
    if (picture.annotations.triad) lay_triad(layout, picture);
    if (picture.annotations.axes) lay_axes(layout, picture);
    return std::move(layout.overlay);
}

} // namespace server::annotations
