// Lays out color bars in columns, from the upper right corner to the left.
#include "annotations/color_ticks.hpp"
#include "annotations/layout.hpp"
#include "annotations/legend_names.hpp"

#include <algorithm>
#include <cmath>

namespace server::annotations {
namespace {

// Lengths of the parts of a legend, in ems.
constexpr double bar_width = 1.3, most_bar = 15, least_bar = 5, tick_start = 0.15, tick_end = 0.5, gap = 0.35,
                 between = 1.6, cap_height = 0.35;
constexpr double widest_title = 0.3; // largest width of a title, as a fraction of the picture's width
constexpr double leftmost_first = 1.0 / 3, leftmost_other = 0.66; // smallest x of columns, as a fraction of the width
constexpr double wide_legend = 0.22, upper_part = 0.55;
constexpr double tick_spacing = 1.7; // smallest distance between two ticks with labels, in lines of text
constexpr int most_ticks = 6;
constexpr double mark_spacing = 4;   // in stroke widths; closer marks look like a solid bar
constexpr double missing_line = 1.9; // additional height of a legend with missing values, in lines of text
constexpr const char* missing_text = "no value";

struct Mark {
    double share = 0; // position on the bar: 0 is the lower end, 1 is the upper end
    std::string label;
};

struct Entry {
    const Legend& legend;
    std::string id; // id of the legend's handle
    std::string title;
    std::vector<std::string> lines; // below the title
    std::vector<Mark> ends;
    double width = 0;
};

std::vector<Mark> end_marks(const Legend& legend) {
    const color::ColorScale& scale = legend.scale;
    if (!color::has_width(scale) && !legend.both_ends) return {{0.5, label_on(scale, scale.range[0])}};
    return {{0, label_on(scale, scale.range[0])}, {1, label_on(scale, scale.range[1])}};
}

std::vector<Mark> inner_marks(const color::ColorScale& scale, int most, int most_marks = color::most_color_steps + 1) {
    std::vector<Mark> marks;
    if (!color::has_width(scale)) return marks;
    for (const ColorTick& tick : color_ticks(scale, most, most_marks)) marks.push_back({tick.at, tick.label});
    return marks;
}

std::vector<std::string> lines_of(const Legend& legend) {
    std::vector<std::string> lines = legend.lines;
    if (!legend.layers.empty()) lines.insert(lines.begin(), legend.layers);
    return lines;
}

Entry entry_of(Layout& layout, const Annotations& annotations, std::size_t index) {
    const Legend& legend = annotations.legends[index];
    const TextSize& size = layout.text();
    const double widest = widest_title * layout.width();
    Entry entry{legend,
                "legend " + std::to_string(index),
                layout.shortened(legend_title(legend.name, legend.units, legend.scale), size, widest),
                {},
                end_marks(legend)};
    for (const std::string& line : lines_of(legend)) entry.lines.push_back(layout.shortened(line, size, widest));
    int labels = 0;
    for (const auto& marks : {entry.ends, inner_marks(legend.scale, most_ticks)})
        for (const Mark& mark : marks) labels = std::max(labels, layout.width_of(mark.label, size));
    const double scale = (bar_width + tick_end + gap) * layout.em() + labels;
    int words = layout.width_of(entry.title, size);
    for (const std::string& line : entry.lines) words = std::max(words, layout.width_of(line, size));
    const double missing =
        legend.missing ? (bar_width + tick_end + gap) * layout.em() + layout.width_of(missing_text, size) : 0;
    entry.width = std::max<double>({scale, static_cast<double>(words), missing, legend.control_width});
    return entry;
}

Ink ink_of(const color::Rgb8& color) {
    const auto [red, green, blue] = color::floats_of(color);
    return {red, green, blue, 1};
}

// Returns pixels. Without a border, an end of the bar that has the color of the background would be invisible.
double border_width(const Layout& layout) { return std::max(1.0, std::round(layout.stroke_width())); }

void draw_cap(Layout& layout, const std::optional<color::Rgb8>& color, const Box& bar, bool at_top) {
    if (!color) return;
    const double border = border_width(layout);
    const double height = std::round(cap_height * layout.em());
    const double top = at_top ? bar.top - border - height : bar.bottom + border;
    layout.overlay.fills.push_back(
        {{bar.left - border, top - border, bar.right + border, top + height + border}, layout.ink(), layout.ink()});
    layout.overlay.fills.push_back({{bar.left, top, bar.right, top + height}, ink_of(*color), ink_of(*color)});
}

// Draws a smooth bar as a stack of linear gradients of about 4 pixels, because colors are nearly linear over 4 pixels.
void draw_bar(Layout& layout, const color::ColorScale& scale, const Box& bar) {
    draw_cap(layout, scale.above, bar, true);
    draw_cap(layout, scale.below, bar, false);
    const double border = border_width(layout);
    layout.overlay.fills.push_back(
        {{bar.left - border, bar.top - border, bar.right + border, bar.bottom + border}, layout.ink(), layout.ink()});
    const int pieces = scale.steps > 0 ? scale.steps : std::clamp(static_cast<int>(bar.height() / 4), 1, 128);
    const std::vector<color::Rgb8> colors =
        scale.steps > 0 ? color::color_row(scale, 0) : color::colors_along(scale, pieces + 1);
    const std::size_t last = colors.size() - 1;
    for (int i = 0; i < pieces; ++i) {
        const double from = static_cast<double>(i) / pieces;
        const double to = static_cast<double>(i + 1) / pieces;
        layout.overlay.fills.push_back(
            {{bar.left, bar.top + from * bar.height(), bar.right, bar.top + to * bar.height()},
             ink_of(colors[last - static_cast<std::size_t>(i)]),
             ink_of(colors[last - static_cast<std::size_t>(scale.steps > 0 ? i : i + 1)])});
    }
}

void draw_tick(Layout& layout, const Box& bar, double y) {
    layout.overlay.strokes.push_back({{bar.right + tick_start * layout.em(), y},
                                      {bar.right + tick_end * layout.em(), y},
                                      layout.stroke_width(),
                                      layout.ink()});
}

// Returns the box of the label. If there is no room for the label, draws and returns nothing.
std::optional<Box> draw_mark(Layout& layout, const Mark& mark, const Box& bar) {
    const TextSize& size = layout.text();
    const int x = static_cast<int>(std::lround(bar.right + (tick_end + gap) * layout.em()));
    const double y = bar.bottom - mark.share * bar.height();
    const int base = static_cast<int>(std::lround(y + size.metrics.digit / 2.0));
    const Box box = layout.box_of(mark.label, size, x, base);
    if (!layout.is_free(box)) return {};
    layout.take(box);
    layout.write(mark.label, size, x, base, layout.ink());
    draw_tick(layout, bar, y);
    return box;
}

void draw_ends(Layout& layout, const Entry& entry, const Box& bar) {
    constexpr std::array<const char*, 2> names{" low", " high"};
    for (std::size_t i = 0; i < entry.ends.size(); ++i) {
        const auto box = draw_mark(layout, entry.ends[i], bar);
        if (box && entry.ends.size() == names.size()) layout.overlay.handles.push_back({entry.id + names[i], *box});
    }
}

void draw_inner_marks(Layout& layout, const color::ColorScale& scale, const Box& bar) {
    const int most = std::clamp(static_cast<int>(bar.height() / (tick_spacing * layout.text().line())), 1, most_ticks);
    const int most_marks = 1 + static_cast<int>(bar.height() / (mark_spacing * layout.stroke_width()));
    for (const Mark& mark : inner_marks(scale, most, most_marks)) {
        if (mark.label.empty())
            draw_tick(layout, bar, bar.bottom - mark.share * bar.height());
        else
            (void)draw_mark(layout, mark, bar);
    }
}

// Draws the color of missing values and its text. Returns their lower end, in pixels from the top of the picture.
double draw_missing(Layout& layout, const color::ColorScale& scale, const Box& bar) {
    const TextSize& size = layout.text();
    const double border = border_width(layout);
    const double top = std::round(bar.bottom + (missing_line - 0.5) * size.line());
    const Box patch{bar.left, top, bar.right, top + std::round(0.6 * size.line())};
    layout.overlay.fills.push_back(
        {{patch.left - border, patch.top - border, patch.right + border, patch.bottom + border},
         layout.ink(),
         layout.ink()});
    layout.overlay.fills.push_back({patch, ink_of(scale.nan), ink_of(scale.nan)});
    const int x = static_cast<int>(std::lround(bar.right + (tick_end + gap) * layout.em()));
    const int base = static_cast<int>(std::lround((patch.top + patch.bottom + size.metrics.digit) / 2));
    layout.write(missing_text, size, x, base, layout.ink());
    return bar.bottom + (missing_line + 0.5) * size.line();
}

// Marks the whole rectangle of the legend as taken, so that nothing else is drawn between the bar and the numbers.
void draw_entry(Layout& layout, const Entry& entry, int left, double top, double bar_height) {
    const TextSize& size = layout.text();
    int base = static_cast<int>(std::lround(top)) + size.metrics.ascent;
    layout.write(entry.title, size, left, base, layout.ink());
    for (const std::string& line : entry.lines) layout.write(line, size, left, base += size.line(), layout.ink());
    const double start = std::round(base + size.metrics.descent + 0.5 * size.line());
    const Box bar{static_cast<double>(left), start, std::round(left + bar_width * layout.em()),
                  start + std::round(bar_height)};
    draw_bar(layout, entry.legend.scale, bar);
    layout.take(bar);
    draw_ends(layout, entry, bar); // before the inner marks, which must not overlap the numbers at the ends
    draw_inner_marks(layout, entry.legend.scale, bar);
    double end = entry.legend.missing ? draw_missing(layout, entry.legend.scale, bar) : bar.bottom + 0.5 * size.line();
    if (entry.legend.control_height > 0) {
        const double start_of_controls = end + gap * layout.em();
        end = start_of_controls + entry.legend.control_height;
        layout.overlay.handles.push_back(
            {entry.id + " controls", {static_cast<double>(left), start_of_controls, left + entry.width, end}});
    }
    const Box all{left - border_width(layout), std::round(top), left + entry.width, end};
    layout.back(all);
    layout.take(all);
    layout.overlay.handles.push_back({entry.id, all});
}

// Returns the height of a column of legends. If the legends do not all fit into the upper part of a narrow picture,
// columns are limited to this part. `least`: smallest height of one legend.
double height_for(Layout& layout, const Annotations& annotations, double least) {
    const double whole = layout.room.height();
    const bool is_narrow = entry_of(layout, annotations, 0).width > wide_legend * layout.width();
    const double upper = layout.height() * upper_part - layout.room.top;
    const auto count = static_cast<double>(annotations.legends.size());
    if (!is_narrow || count * least <= upper || upper < least) return whole;
    return upper;
}

void note_left_out(Layout& layout, PicturePoint corner, std::size_t count) {
    const TextSize& size = layout.text();
    const std::string text = "+ " + std::to_string(count) + " more";
    const std::string fitting = layout.shortened(text, size, layout.room.right - corner.x);
    const int base = static_cast<int>(std::lround(corner.y + 0.3 * size.line())) + size.metrics.ascent;
    const int left = static_cast<int>(corner.x);
    if (fitting.empty() || !layout.is_free(layout.box_of(fitting, size, left, base))) return;
    layout.write_backed(fitting, size, left, base);
    layout.take(layout.box_of(fitting, size, left, base));
}

} // namespace

void lay_legends(Layout& layout, const Annotations& annotations) {
    if (annotations.legends.empty()) return;
    const double em = layout.em();
    const double line = layout.text().line();
    std::size_t most_lines = 0;
    double controls = 0;
    for (const Legend& legend : annotations.legends) {
        most_lines = std::max(most_lines, lines_of(legend).size());
        if (legend.control_height > 0) controls = std::max(controls, gap * em + legend.control_height);
    }
    const auto is_missing = [](const Legend& legend) { return legend.missing; };
    const bool any_missing = std::any_of(annotations.legends.begin(), annotations.legends.end(), is_missing);
    // Height of a legend without its bar.
    const double around = (2 + static_cast<double>(most_lines) + (any_missing ? missing_line : 0)) * line + controls;
    const double least = around + (least_bar + between) * em;
    const double height = height_for(layout, annotations, least);
    double right = layout.room.right;
    const std::size_t legends = annotations.legends.size();
    std::size_t next = 0;
    PicturePoint below{}; // the lower left corner of the last column
    while (next < legends) {
        const auto left_over = static_cast<double>(legends - next);
        const double fitting = std::floor((height + between * em) / least);
        const double count = std::min(left_over, fitting);
        if (count < 1) break;
        const double block = (height + between * em) / count;
        const double bar_height = std::min(most_bar * em, block - around - between * em);
        std::vector<Entry> column;
        double width = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            column.push_back(entry_of(layout, annotations, next + i));
            width = std::max(width, column.back().width);
        }
        const int left = static_cast<int>(std::floor(right - width));
        double top = layout.room.top;
        const Box all{static_cast<double>(left), top, right, top + count * block - between * em};
        const double leftmost = (next == 0 ? leftmost_first : leftmost_other) * layout.width();
        if (left < leftmost || !layout.is_free(all)) break;
        for (const Entry& entry : column) {
            draw_entry(layout, entry, left, top, bar_height);
            top += around + bar_height + between * em;
        }
        next += static_cast<std::size_t>(count);
        below = {static_cast<double>(left), top - between * em};
        right = left - between * em;
    }
    if (next > 0 && next < legends) note_left_out(layout, below, legends - next);
}

} // namespace server::annotations
