// From a scalar to a color. The rule is in protocol/colors.md; the server's shaders, the browser
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
    std::vector<ColorPoint> points; // two or more, ascending: replace the map; linear in sRGB between them
    // Exactly as given, since legends show it; pixels use the nearest floats. When `log`: above zero, or from -r to r.
    std::array<double, 2> range{0, 1};
    bool reverse = false, log = false; // log: equal factors are equally long
    int steps = 0;                     // 0: smooth; else 2 to most_color_steps
    Rgb8 nan{128, 128, 128};
    std::optional<Rgb8> below, above;
    bool operator==(const ColorScale&) const = default;
};

inline constexpr int most_color_steps = 256;
inline constexpr double linear_share = 1e-3; // of the end of a range that is logarithmic on both sides of zero

[[nodiscard]] inline bool is_log_of_both_signs(const ColorScale& scale) { return scale.log && scale.range[0] < 0; }

// Returns `count` colors from the lower to the upper end, evenly spaced, for a texture or a legend's bar. On a stepped
// scale, each is the color of its step. Throws Error for an unknown map.
[[nodiscard]] std::vector<Rgb8> colors_along(const ColorScale& scale, int count);
// Returns one color per step, or `smooth_count` colors to interpolate for a smooth scale.
[[nodiscard]] std::vector<Rgb8> color_row(const ColorScale& scale, int smooth_count);

// 0 at the lower end, 1 at the upper end, less or more outside; -infinity for log of zero or less; NaN for NaN.
[[nodiscard]] double place_of(const ColorScale& scale, double value);
// The inverse of place_of.
[[nodiscard]] double value_at(const ColorScale& scale, double place);
// The complete rule, on the CPU.
[[nodiscard]] Rgb8 color_of(const ColorScale& scale, double value);

// Values from `low` to `high` are inside.
struct ColorLimits {
    float low = 0, high = 0;
};
[[nodiscard]] ColorLimits limits_of(const ColorScale& scale);
// Whether the range has a width as floats. Without, or with a width beyond float, all values have the middle color.
[[nodiscard]] bool has_width(const ColorScale& scale);

} // namespace ciel::color
