// ColorScale: maps scalars to colors. The rule is in protocol/colors.md; the server's shaders, the browser
// (webclient/src/model/color_scale.ts) and every legend follow it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ciel::color {

using Rgb8 = std::array<std::uint8_t, 3>; // sRGB

// Returns the channels as shaders take them, from 0 to 1.
[[nodiscard]] inline std::array<float, 3> floats_of(const Rgb8& color) {
    return {static_cast<float>(color[0]) / 255.0F, static_cast<float>(color[1]) / 255.0F,
            static_cast<float>(color[2]) / 255.0F};
}

struct ColorPoint {
    double at = 0; // position on the scale, from 0 to 1
    Rgb8 color{};
    bool operator==(const ColorPoint&) const = default;
};

struct ColorScale {
    std::string map = "viridis";
    std::vector<ColorPoint> points; // if not empty: at least two, ascending; replace `map`; linear in sRGB between them
    // Values of the two ends, as the scene gives them. With `log` both are above zero, or the range goes from -r to r.
    std::array<double, 2> range{0, 1};
    bool reverse = false, log = false; // log: equal factors have equal lengths on the scale
    int steps = 0;                     // number of steps, 2 to most_color_steps; 0: a smooth scale
    Rgb8 nan{128, 128, 128};
    std::optional<Rgb8> below, above;
    bool operator==(const ColorScale&) const = default;
};

inline constexpr int most_color_steps = 256;
// A log scale from -r to r places a value v by sign(v) log(1 + |v| / w): nearly linear up to w. This is w / r
// (protocol/colors.md).
inline constexpr double linear_share = 1e-3;

[[nodiscard]] inline bool is_log_of_both_signs(const ColorScale& scale) { return scale.log && scale.range[0] < 0; }

// Returns the colors at `count` evenly spaced positions from the lower to the upper end, for a texture or a legend's
// bar. On a scale with steps, each is the color of its step. Throws Error for an unknown map.
[[nodiscard]] std::vector<Rgb8> colors_along(const ColorScale& scale, int count);
// Returns one color per step, or `smooth_count` colors to interpolate for a smooth scale.
[[nodiscard]] std::vector<Rgb8> color_row(const ColorScale& scale, int smooth_count);

// Returns the position of a value on the scale: 0 at the lower end, 1 at the upper end, below 0 or above 1 outside, NaN
// for NaN. On a log scale above zero, values of zero or less have the position -infinity.
[[nodiscard]] double place_of(const ColorScale& scale, double value);
// Returns the value at a position: the inverse of place_of.
[[nodiscard]] double value_at(const ColorScale& scale, double place);
// Returns the color of one value by the complete rule, including steps, `nan`, `below` and `above`.
[[nodiscard]] Rgb8 color_of(const ColorScale& scale, double value);

// Values from `low` to `high` count as inside the range. The limits allow for the rounding of interpolated floats.
struct ColorLimits {
    double low = 0, high = 0;
};
[[nodiscard]] ColorLimits limits_of(const ColorScale& scale);
// Returns whether the width of the range, as a float, is positive and finite. If not, all values have the middle color.
[[nodiscard]] bool has_width(const ColorScale& scale);

} // namespace ciel::color
