#include "annotations/color_ticks.hpp"

#include "annotations/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace server::annotations {
namespace {

constexpr int most_labels = 10; // largest number of labels at steps or powers of ten; more labels would overlap
constexpr int most_marked_decades = 8;

struct Marks {
    const color::ColorScale& scale;
    std::vector<ColorTick> ticks;

    void add(double value, bool has_label) { add(value, has_label ? label_on(scale, value) : std::string()); }
    void add(double value, std::string label) {
        ticks.push_back({value, std::clamp(color::place_of(scale, value), 0.0, 1.0), std::move(label)});
    }
    void add_round_values(int most) {
        for (Tick& tick : nice_scale(scale.range[0], scale.range[1], most).ticks)
            add(tick.value, std::move(tick.label));
    }
};

// Returns n: every n-th bound between color steps gets a mark. n divides stride_of_labels, so every label is at a mark.
int stride_of_marks(int steps, int stride_of_labels, int most) {
    for (int stride = 1; stride < stride_of_labels; ++stride)
        if (stride_of_labels % stride == 0 && steps / stride < most) return stride;
    return stride_of_labels;
}

void add_steps(Marks& marks, int most) {
    const color::ColorScale& scale = marks.scale;
    const int stride = (scale.steps + most_labels - 1) / most_labels;
    for (int k = 0; k <= scale.steps; k += stride_of_marks(scale.steps, stride, most)) {
        const int to_the_end = scale.steps - k;
        // Leaves out a mark that would be too close to the end of the scale.
        if (to_the_end > 0 && to_the_end * most < scale.steps) continue;
        marks.add(color::value_at(scale, static_cast<double>(k) / scale.steps), k % stride == 0);
    }
}

// Adds marks at powers of ten and their multiples. The multiples in `with` get labels at every `stride`-th power.
void add_decades(Marks& marks, double low, double high, const std::vector<int>& with, int stride) {
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const bool has_marks = last - first <= most_marked_decades;
    for (int decade = first; decade <= last; ++decade)
        for (int multiple = 1; multiple <= (has_marks ? 9 : 1); ++multiple) {
            const double value = multiple * std::pow(10.0, decade);
            if (value < low * (1 - 1e-6) || value > high * (1 + 1e-6)) continue;
            const bool is_labelled = std::find(with.begin(), with.end(), multiple) != with.end();
            marks.add(value, is_labelled && decade % stride == 0);
        }
}

int labels_of(const std::vector<ColorTick>& ticks) {
    return static_cast<int>(
        std::count_if(ticks.begin(), ticks.end(), [](const ColorTick& t) { return !t.label.empty(); }));
}

// The scale is nearly linear around zero. This part has no marks except zero.
void add_both_signs(Marks& marks) {
    const double reach = marks.scale.range[1];
    Marks above{marks.scale, {}};
    add_decades(above, color::linear_share * reach, reach, {1}, 1);
    for (auto tick = above.ticks.rbegin(); tick != above.ticks.rend(); ++tick)
        marks.add(-tick->value, !tick->label.empty());
    marks.add(0, true);
    marks.ticks.insert(marks.ticks.end(), above.ticks.begin(), above.ticks.end());
}

void add_log(Marks& marks, int most) {
    const auto [low, high] = marks.scale.range;
    const int decades = static_cast<int>(std::floor(std::log10(high / low)));
    const int stride = std::max(1, (decades + most_labels - 1) / most_labels);
    for (const std::vector<int>& with : {std::vector<int>{1}, std::vector<int>{1, 2, 5}}) {
        marks.ticks.clear();
        add_decades(marks, low, high, with, stride);
        if (labels_of(marks.ticks) >= 3) return;
    }
    marks.ticks.clear();
    marks.add_round_values(most);
}

} // namespace

int exponent_of(const color::ColorScale& scale) {
    return scale.log ? 0 : common_exponent(scale.range[0], scale.range[1]);
}

std::string label_on(const color::ColorScale& scale, double value) {
    // If a logarithmic bar spans a factor of 10 or more, at most 3 digits can be read from it.
    if (scale.log) return number_label(value, scale.range[1] >= 10 * scale.range[0] ? 3 : 6);
    return number_label(value, color::has_width(scale) ? scale.range[1] - scale.range[0] : 0, exponent_of(scale));
}

std::vector<ColorTick> color_ticks(const color::ColorScale& scale, int most, int most_marks) {
    Marks marks{scale, {}};
    if (!color::has_width(scale))
        marks.add(scale.range[0], true);
    else if (scale.steps > 1)
        add_steps(marks, most_marks);
    else if (color::is_log_of_both_signs(scale))
        add_both_signs(marks);
    else if (scale.log)
        add_log(marks, most);
    else
        marks.add_round_values(most);
    return std::move(marks.ticks);
}

} // namespace server::annotations
