// Ticks, numbers and names along three edges of the bounding box.
#include "annotations/box_edges.hpp"
#include "annotations/layout.hpp"
#include "annotations/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ciel::annotations {
namespace {

// In ems.
constexpr double tick_length = 0.5, gap = 0.35, apart = 0.5, least_edge = 3;
constexpr double across_spacing = 3.6, up_spacing = 2.4; // least distance of ticks, along and across lines of text
constexpr int most_ticks = 10;
constexpr std::array names{"x", "y", "z"};

struct Placed {
    std::string text;
    int x = 0, y = 0;
    Box box;
};

struct Numbered {
    double value = 0;
    Placed label;
};

class AxisLayout {
public:
    AxisLayout(Layout& layout, const AnnotatedPicture& picture, const BoxEdge& edge)
        : layout_(layout), picture_(picture), projection_(picture), edge_(edge) {}

    void draw_line() { layout_.draw_line(at(edge_.from), at(edge_.to)); }

    void write() {
        const Place a = at(edge_.from);
        const Place b = at(edge_.to);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double spacing =
            (across_spacing * std::abs(edge_.outward.y) + up_spacing * std::abs(edge_.outward.x)) * layout_.em();
        int most = std::clamp(static_cast<int>(length / spacing), 3, most_ticks);
        while (!number(most) && most > 1) --most;
        write_numbers();
        write_name();
    }

private:
    [[nodiscard]] Place at(double share) const { return projection_.pixel(glm::mix(edge_.low, edge_.high, share)); }
    [[nodiscard]] double value(double share) const {
        return glm::mix(edge_.low[edge_.axis], edge_.high[edge_.axis], share);
    }
    [[nodiscard]] double share(double value) const {
        const double low = edge_.low[edge_.axis];
        return (value - low) / (edge_.high[edge_.axis] - low);
    }

    // Places text so that it begins `distance` outside the edge. Text that would leave the picture is moved into it.
    [[nodiscard]] Placed beside(Place foot, const std::string& text, double distance) {
        const TextSize& size = layout_.text();
        const double half_width = layout_.width_of(text, size) / 2.0;
        const double half_height = size.metrics.digit / 2.0;
        const double away = distance + std::abs(edge_.outward.x) * half_width + std::abs(edge_.outward.y) * half_height;
        const double x = foot.x + away * edge_.outward.x - half_width;
        const double y = foot.y + away * edge_.outward.y + half_height;
        const double right = layout_.width() - 2 * half_width - 1;
        const double bottom = layout_.height() - size.metrics.descent;
        Placed placed{text,
                      static_cast<int>(std::lround(std::clamp(x, 1.0, std::max(1.0, right)))),
                      static_cast<int>(std::lround(
                          std::clamp<double>(y, size.metrics.ascent, std::max<double>(size.metrics.ascent, bottom)))),
                      {}};
        placed.box = layout_.box_of(text, size, placed.x, placed.y);
        return placed;
    }

    // Places the numbers and returns whether they keep clear of each other at this density. Numbers that would overlap
    // other annotations, such as another axis's number at a common corner, are left out at any density.
    bool number(int most) {
        const Scale scale = nice_scale(value(edge_.from), value(edge_.to), most);
        exponent_ = scale.exponent;
        numbers_.clear();
        bool are_clear = true;
        for (const Tick& tick : scale.ticks) {
            Placed label = beside(at(share(tick.value)), tick.label, (tick_length + gap) * layout_.em());
            if (!layout_.is_free(with_room(label.box))) continue;
            if (is_clear(label.box))
                numbers_.push_back({tick.value, std::move(label)});
            else
                are_clear = false;
        }
        return are_clear;
    }

    // Widens a number's box: adjacent numbers, as at a common corner of two axes, would read as one.
    [[nodiscard]] Box with_room(const Box& box) const {
        const double room = apart * layout_.em() / 2;
        return {std::max(0.0, box.left - room), box.top, std::min<double>(layout_.width(), box.right + room),
                box.bottom};
    }

    [[nodiscard]] bool is_clear(const Box& label) const {
        const Box box = with_room(label);
        return std::none_of(numbers_.begin(), numbers_.end(),
                            [&](const Numbered& other) { return other.label.box.overlaps(box); });
    }

    void write(const Placed& placed) {
        layout_.take(placed.box);
        layout_.write_backed(placed.text, layout_.text(), placed.x, placed.y);
    }

    void write_numbers() {
        const double length = tick_length * layout_.em();
        for (const Numbered& one : numbers_) {
            const Place foot = at(share(one.value));
            layout_.draw_line(foot, {foot.x + length * edge_.outward.x, foot.y + length * edge_.outward.y});
        }
        // In a steep view, a number may overlap its neighbour's tick.
        std::erase_if(numbers_, [&](const Numbered& one) { return !layout_.is_free(one.label.box); });
        for (const Numbered& one : numbers_) write(one.label);
    }

    // Writes the name outside the numbers, as near to the middle of the edge as there is room.
    void write_name() {
        const std::string units = pretty_units(picture_.annotations.length_units);
        const std::string name = std::string(names[static_cast<std::size_t>(edge_.axis)]) +
                                 (units.empty() ? "" : " [" + units + "]") + times_power_of_ten(exponent_);
        double depth = 0;
        for (const Numbered& one : numbers_)
            depth = std::max(depth, std::abs(edge_.outward.x) * one.label.box.width() +
                                        std::abs(edge_.outward.y) * layout_.text().metrics.digit);
        const double distance = depth + (tick_length + 2.2 * gap) * layout_.em();
        for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.15, 0.85, 0.0, 1.0}) {
            const Placed placed = beside(at(glm::mix(edge_.from, edge_.to, share)), name, distance);
            if (!layout_.is_free(placed.box)) continue;
            write(placed);
            return;
        }
    }

    Layout& layout_;
    const AnnotatedPicture& picture_;
    Projection projection_;
    const BoxEdge& edge_;
    std::vector<Numbered> numbers_;
    int exponent_ = 0;
};

} // namespace

void lay_axes(Layout& layout, const AnnotatedPicture& picture) {
    const std::vector<BoxEdge> edges = axis_edges(picture, least_edge * layout.em());
    std::vector<AxisLayout> axes;
    axes.reserve(edges.size());
    for (const BoxEdge& edge : edges) axes.emplace_back(layout, picture, edge);
    for (AxisLayout& axis : axes) axis.draw_line(); // all lines first, so that no number covers another axis's line
    for (AxisLayout& axis : axes) axis.write();
}

} // namespace ciel::annotations
