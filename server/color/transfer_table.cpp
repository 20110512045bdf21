// This work is based on: K. Engel, M. Kraus, T. Ertl, High-Quality Pre-Integrated Volume Rendering Using
// Hardware-Accelerated Pixel Shading (Graphics Hardware 2001).
#include "color/transfer_table.hpp"

#include <algorithm>
#include <cmath>

namespace server::color {
namespace {

using Color = std::array<double, 4>; // R, G and B times extinction, then extinction

constexpr int color_entries = 256;
constexpr int samples = 4 * TransferTable::columns; // samples along the table; enough for steep steps of the opacity

std::vector<Rgb8> colors_of(const ColorScale& scale) {
    std::vector<Rgb8> colors;
    for (int i = 0; i < color_entries; ++i) {
        const double share = static_cast<double>(i) / (color_entries - 1);
        colors.push_back(color_of(scale, std::lerp(scale.range[0], scale.range[1], share)));
    }
    return colors;
}

std::array<double, 3> color_at(const ColorScale& scale, const std::vector<Rgb8>& map, double place) {
    const double entry = std::clamp(place, 0.0, 1.0) * (color_entries - 1);
    const auto low = static_cast<std::size_t>(entry);
    const std::size_t high = std::min<std::size_t>(low + 1, color_entries - 1);
    const Rgb8& outside = place < 0 ? scale.below.value_or(map[low]) : scale.above.value_or(map[high]);
    const bool is_outside = place < 0 || place > 1;
    std::array<double, 3> color{};
    for (std::size_t c = 0; c < 3; ++c)
        color[c] =
            (is_outside ? outside[c] : std::lerp(map[low][c], map[high][c], entry - static_cast<double>(low))) / 255.0;
    return color;
}

Color at(const ColorScale& scale, const OpacityPoints& opacity, double share, const std::vector<Rgb8>& map,
         double place) {
    const double in_range = table_extent(scale).share_at(place);
    const double tau = extinction_of(share * opacity_at(opacity, in_range));
    const auto [r, g, b] = color_at(scale, map, in_range);
    return {r * tau, g * tau, b * tau, tau};
}

std::vector<Color> integrals(const ColorScale& scale, const OpacityPoints& opacity, double share) {
    const std::vector<Rgb8> map = colors_of(scale);
    std::vector<Color> sum(samples + 1);
    for (std::size_t i = 0; i < samples; ++i) {
        const Color here = at(scale, opacity, share, map, (static_cast<double>(i) + 0.5) / samples);
        for (std::size_t c = 0; c < 4; ++c) sum[i + 1][c] = sum[i][c] + here[c] / samples;
    }
    return sum;
}

Color interpolated(const std::vector<Color>& sum, double place) {
    const double entry = std::clamp(place, 0.0, 1.0) * samples;
    const auto low = std::min<std::size_t>(static_cast<std::size_t>(entry), samples - 1);
    Color out{};
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = std::lerp(sum[low][c], sum[low + 1][c], entry - static_cast<double>(low));
    return out;
}

} // namespace

double extinction_of(double opacity) { return -std::log1p(-std::clamp(opacity, 0.0, 0.999)); }

double opacity_at(const OpacityPoints& points, double place) {
    if (points.empty()) return 0;
    const auto after = std::ranges::upper_bound(points, place, {}, [](const auto& point) { return point[0]; });
    if (after == points.begin()) return points.front()[1];
    if (after == points.end()) return points.back()[1];
    const auto& [from, low] = *(after - 1);
    const auto& [to, high] = *after;
    return std::lerp(low, high, (place - from) / (to - from));
}

std::array<double, 2> TableExtent::values(const std::array<double, 2>& range) const {
    return {std::lerp(range[0], range[1], share_at(0)), std::lerp(range[0], range[1], share_at(1))};
}

TableExtent table_extent(const ColorScale& scale) { return {scale.below ? 1 : 0, scale.above ? 1 : 0}; }

TransferTable make_transfer_table(const ColorScale& scale, const OpacityPoints& opacity, double share) {
    const std::vector<Color> sum = integrals(scale, opacity, share);
    const std::vector<Rgb8> map = colors_of(scale);
    TransferTable table;
    table.texels.reserve(std::size_t{4} * TransferTable::columns * TransferTable::rows);
    for (int row = 0; row < TransferTable::rows; ++row)
        for (int column = 0; column < TransferTable::columns; ++column) {
            const double middle = (column + 0.5) / TransferTable::columns;
            // The intervals of row 0 are one column wide instead of 0, so that adjacent columns have no gap.
            const double width =
                std::max(static_cast<double>(row) / (TransferTable::rows - 1), 1.0 / TransferTable::columns);
            const double low = std::max(middle - width / 2, 0.0), high = std::min(middle + width / 2, 1.0);
            const Color below = interpolated(sum, low), above = interpolated(sum, high);
            const double tau = above[3] - below[3];
            const Color plain = at(scale, opacity, share, map, middle);
            for (std::size_t c = 0; c < 3; ++c)
                table.texels.push_back(static_cast<float>(tau > 0 ? (above[c] - below[c]) / tau : plain[c]));
            table.texels.push_back(static_cast<float>(tau / (high - low)));
        }
    return table;
}

} // namespace server::color
