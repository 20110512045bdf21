// The title across the top, and lines of text at the upper left.
#include "render/annotations/page.hpp"

#include <cmath>

namespace ciel::render {
namespace {

constexpr double widest_caption = 0.45; // of the picture

int whole(double pixels) { return static_cast<int>(std::lround(pixels)); }

} // namespace

void lay_title(Page& page, const Annotations& annotations) {
    const TextSize& size = page.heading();
    const std::string text = page.shortened(annotations.title, size, page.room.width());
    const int base = whole(page.room.top) + size.metrics.ascent;
    const int left = (page.width() - page.width_of(text, size)) / 2;
    const Box box = page.box_of(text, size, left, base);
    if (text.empty() || !page.is_free(box)) return;
    page.write_backed(text, size, left, base);
    page.take(box);
    page.room.top = box.bottom + page.em() / 2; // the rest stands below it
}

void lay_captions(Page& page, const Annotations& annotations) {
    const TextSize& size = page.text();
    const int left = whole(page.room.left);
    int base = whole(page.room.top) + size.metrics.ascent;
    for (const std::string& caption : annotations.captions) {
        const std::string text = page.shortened(caption, size, widest_caption * page.width());
        const Box box = page.box_of(text, size, left, base);
        if (text.empty() || !page.is_free(box)) continue;
        page.write_backed(text, size, left, base);
        page.take(box);
        base += size.line();
    }
}

} // namespace ciel::render
