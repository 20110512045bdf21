// Lays out the title at the top and the captions at the upper left.
#include "annotations/layout.hpp"

#include <cmath>

namespace server::annotations {
namespace {

constexpr double widest_caption = 0.45; // largest width of a caption, as a fraction of the picture's width

int whole(double pixels) { return static_cast<int>(std::lround(pixels)); }

} // namespace

void lay_title(Layout& layout, const Annotations& annotations) {
    const TextSize& size = layout.heading();
    const std::string text = layout.shortened(annotations.title, size, layout.room.width());
    const int base = whole(layout.room.top) + size.metrics.ascent;
    const int left = (layout.width() - layout.width_of(text, size)) / 2;
    const Box box = layout.box_of(text, size, left, base);
    if (text.empty() || !layout.is_free(box)) return;
    layout.write_backed(text, size, left, base);
    layout.take(box);
    layout.room.top = box.bottom + layout.em() / 2; // all later annotations are below the title
}

void lay_captions(Layout& layout, const Annotations& annotations) {
    const TextSize& size = layout.text();
    const int left = whole(layout.room.left);
    int base = whole(layout.room.top) + size.metrics.ascent;
    for (const std::string& caption : annotations.captions) {
        const std::string text = layout.shortened(caption, size, widest_caption * layout.width());
        const Box box = layout.box_of(text, size, left, base);
        if (text.empty() || !layout.is_free(box)) continue;
        layout.write_backed(text, size, left, base);
        layout.take(box);
        base += size.line();
    }
}

} // namespace server::annotations
