#include "wire/batches/quantize.hpp"

#include <algorithm>
#include <cmath>

namespace server::wire {

double grid_step(double wanted, double largest) {
    const double finest = std::ldexp(std::max(largest, double{std::numeric_limits<float>::min()}), -23);
    return std::exp2(std::floor(std::log2(std::max(wanted, finest))));
}

std::array<std::int8_t, 2> octahedral(const ciel::Vec3f& normal) {
    const float length = std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]);
    if (!(length > 0)) return {0, 0};
    float x = normal[0] / length, y = normal[1] / length;
    if (normal[2] < 0) {
        const float folded = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
        x = folded;
    }
    const auto place = [](float at) { return static_cast<std::int8_t>(std::lrint(127 * std::clamp(at, -1.0F, 1.0F))); };
    return {place(x), place(y)};
}

ciel::Vec3f from_octahedral(const std::array<std::int8_t, 2>& place) {
    float x = static_cast<float>(place[0]) / 127, y = static_cast<float>(place[1]) / 127;
    const float z = 1 - std::abs(x) - std::abs(y);
    if (z < 0) {
        const float unfolded = (1 - std::abs(y)) * (x < 0 ? -1.0F : 1.0F);
        y = (1 - std::abs(x)) * (y < 0 ? -1.0F : 1.0F);
        x = unfolded;
    }
    const float length = std::sqrt(x * x + y * y + z * z);
    return {x / length, y / length, z / length};
}

QuantizedValues quantized(std::span<const double> values, double origin, double step) {
    constexpr double most = 1 << 30;
    constexpr std::int64_t nothing = std::numeric_limits<std::int64_t>::max();
    QuantizedValues out;
    std::vector<std::int64_t> steps;
    steps.reserve(values.size());
    std::int64_t low = nothing;
    for (const double value : values) {
        const bool is_number = !std::isnan(value);
        const double at = is_number ? std::clamp((value - origin) / step, -most, most) : 0;
        steps.push_back(is_number ? std::llrint(at) : nothing);
        low = std::min(low, steps.back());
    }
    out.low = low == nothing ? 0 : low;
    out.places.reserve(values.size());
    for (const std::int64_t at : steps)
        out.places.push_back(at == nothing ? no_value : static_cast<std::uint32_t>(at - out.low));
    return out;
}

} // namespace server::wire
