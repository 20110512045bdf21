// Lays out the axes of a picture: ticks, numbers and a name along up to three edges of the bounding box.
#include "annotations/box_edges.hpp"
#include "annotations/layout.hpp"
#include "annotations/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace server::annotations {
namespace {

// In ems (font sizes). gap: from tick to number. apart: between two numbers. least_edge: shorter edges get no axis.
constexpr double tick_length = 0.5, gap = 0.35, apart = 0.5, least_edge = 3;
constexpr double across_spacing = 3.6, up_spacing = 2.4; // ems between two ticks on a horizontal and on a vertical edge
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
        const PicturePoint a = at(edge_.from);
        const PicturePoint b = at(edge_.to);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double spacing =
            (across_spacing * std::abs(edge_.outward.y) + up_spacing * std::abs(edge_.outward.x)) * layout_.em();
        int most = std::clamp(static_cast<int>(length / spacing), 3, most_ticks);
        while (!number(most) && most > 1) --most;
        write_numbers();
        write_name();
    }

private:
    [[nodiscard]] PicturePoint at(double share) const {
        return projection_.pixel(glm::mix(edge_.low, edge_.high, share));
    }
    [[nodiscard]] double value(double share) const {
        return glm::mix(edge_.low[edge_.axis], edge_.high[edge_.axis], share);
    }
    [[nodiscard]] double share(double value) const {
        const double low = edge_.low[edge_.axis];
        return (value - low) / (edge_.high[edge_.axis] - low);
    }

    // Returns the text centered at `middle`. A text that would extend beyond the picture is moved inside.
    [[nodiscard]] Placed around(PicturePoint middle, const std::string& text) {
        const TextSize& size = layout_.text();
        const double half_width = layout_.width_of(text, size) / 2.0;
        const double x = middle.x - half_width;
        const double y = middle.y + size.metrics.digit / 2.0;
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

    [[nodiscard]] double half_along(const PicturePoint& direction, const std::string& text) {
        return std::abs(direction.x) * layout_.width_of(text, layout_.text()) / 2.0 +
               std::abs(direction.y) * layout_.text().metrics.digit / 2.0;
    }

    [[nodiscard]] Placed beside(PicturePoint foot, const std::string& text, double distance) {
        const double away = distance + half_along(edge_.outward, text);
        return around({foot.x + away * edge_.outward.x, foot.y + away * edge_.outward.y}, text);
    }

    // Leaves out numbers that would overlap another annotation. Returns false if two numbers are too close.
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

    // Widens the box of a number, because two adjacent numbers without a gap would look like one number.
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
            const PicturePoint foot = at(share(one.value));
            layout_.draw_line(foot, {foot.x + length * edge_.outward.x, foot.y + length * edge_.outward.y});
        }
        // In steep views, a number may overlap the tick of an adjacent number. Such numbers are left out.
        std::erase_if(numbers_, [&](const Numbered& one) { return !layout_.is_free(one.label.box); });
        for (const Numbered& one : numbers_) write(one.label);
    }

    [[nodiscard]] std::string name() {
        const std::string units = pretty_units(picture_.annotations.length_units);
        const std::string whole = std::string(names[static_cast<std::size_t>(edge_.axis)]) +
                                  (units.empty() ? "" : " [" + units + "]") + times_power_of_ten(exponent_);
        return layout_.shortened(whole, layout_.text(), layout_.width() - 2);
    }

    // Best place first: outside the numbers, from the middle of the edge to its ends, then beyond the ends of the edge.
    [[nodiscard]] std::vector<Placed> places_of(const std::string& name) {
        double depth = 0;
        for (const Numbered& one : numbers_)
            depth = std::max(depth, std::abs(edge_.outward.x) * one.label.box.width() +
                                        std::abs(edge_.outward.y) * layout_.text().metrics.digit);
        const double distance = depth + (tick_length + 2.2 * gap) * layout_.em();
        std::vector<Placed> places;
        for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.15, 0.85, 0.0, 1.0})
            places.push_back(beside(at(glm::mix(edge_.from, edge_.to, share)), name, distance));
        const PicturePoint from = at(edge_.from), to = at(edge_.to);
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        const PicturePoint along{(to.x - from.x) / length, (to.y - from.y) / length};
        const double past = (apart + 2 * gap) * layout_.em() + half_along(along, name);
        places.push_back(around({to.x + past * along.x, to.y + past * along.y}, name));
        places.push_back(around({from.x - past * along.x, from.y - past * along.y}, name));
        return places;
    }

    void write_name() {
        const std::string text = name();
        if (text.empty()) return;
        const std::vector<Placed> places = places_of(text);
        const auto free =
            std::ranges::find_if(places, [&](const Placed& placed) { return layout_.is_free(placed.box); });
        if (free != places.end()) write(*free);
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
    // Draws all lines first, so that no number covers the line of another axis.
    for (AxisLayout& axis : axes) axis.draw_line();
    for (AxisLayout& axis : axes) axis.write();
}

} // namespace server::annotations
