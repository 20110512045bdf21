// ColorScale: maps scalars to colors by the rule of protocol/colors.md. The web page runs the same code (server/page).
// The shaders use the same rule (scale_rules.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace server::color {

using Rgb8 = std::array<std::uint8_t, 3>; // sRGB

// Returns the channels for shaders, from 0 to 1.
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
    // If not empty, replaces `map`: at least two points, ascending. Colors between two points are linear in sRGB.
    std::vector<ColorPoint> points;
    // Values at the lower and the upper end of the scale. With `log`, both values are above zero, or the range goes
    // from -r to r.
    std::array<double, 2> range{0, 1};
    bool reverse = false, log = false; // log: equal ratios of values have equal lengths on the scale
    int steps = 0;                     // number of color steps, from 2 to most_color_steps; 0: a smooth scale
    Rgb8 nan{128, 128, 128};
    std::optional<Rgb8> below, above;
    bool operator==(const ColorScale&) const = default;
};

inline constexpr int most_color_steps = 256;
// On a log scale from -r to r, the position of a value v depends on sign(v) log(1 + |v| / w). The scale is nearly
// linear for |v| up to w. linear_share is w / r (protocol/colors.md).
inline constexpr double linear_share = 1e-3;

[[nodiscard]] inline bool is_log_of_both_signs(const ColorScale& scale) { return scale.log && scale.range[0] < 0; }

// Returns the colors at `count` evenly spaced positions from the lower to the upper end, for a texture or the bar of a
// legend. On a scale with steps, each color is the color of the step at this position. Throws Error for an unknown map.
[[nodiscard]] std::vector<Rgb8> colors_along(const ColorScale& scale, int count);
// Returns one color per step. For a smooth scale, returns `smooth_count` colors to interpolate. Throws Error for an
// unknown map.
[[nodiscard]] std::vector<Rgb8> color_row(const ColorScale& scale, int smooth_count);

// Returns 0 at the lower end and 1 at the upper end; below 0 or above 1 outside the range; NaN for NaN. On a log scale
// above zero, zero and negative values have the position -infinity.
[[nodiscard]] double place_of(const ColorScale& scale, double value);
// Returns the value at a position: the inverse of place_of.
[[nodiscard]] double value_at(const ColorScale& scale, double place);
// Returns the color of missing values for NaN and infinities. Throws Error for an unknown map.
[[nodiscard]] Rgb8 color_of(const ColorScale& scale, double value);

// Values from `low` to `high` are treated as inside the range. The limits allow for the rounding of interpolated
// floats.
struct ColorLimits {
    double low = 0, high = 0;
};
[[nodiscard]] ColorLimits limits_of(const ColorScale& scale);
// Returns whether the width of the range, as a float, is positive and finite. If not, all finite values have the color
// at the middle of the scale.
[[nodiscard]] bool has_width(const ColorScale& scale);

} // namespace server::color
