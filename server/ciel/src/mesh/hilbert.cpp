#include "mesh/hilbert.hpp"

#include <algorithm>

namespace ciel::detail {

namespace {

constexpr int bits = 21;
using Axes = std::array<std::uint32_t, 3>;

Axes quantise(Vec3d unit) {
    constexpr double top = (1U << bits) - 1;
    Axes axes{};
    for (std::size_t i = 0; i < 3; ++i)
        axes[i] = unit[i] > 0 ? static_cast<std::uint32_t>(std::min(unit[i], 1.0) * top) : 0;
    return axes;
}

// Converts to Skilling's "transposed" index: bit b of the three words gives three consecutive bits of the key.
void to_transposed(Axes& axes) {
    for (std::uint32_t q = 1U << (bits - 1); q > 1; q >>= 1) {
        const std::uint32_t below = q - 1;
        for (std::uint32_t& axis : axes) {
            if (axis & q) {
                axes[0] ^= below;
            } else {
                const std::uint32_t swap = (axes[0] ^ axis) & below;
                axes[0] ^= swap;
                axis ^= swap;
            }
        }
    }
    axes[1] ^= axes[0];
    axes[2] ^= axes[1];
    std::uint32_t gray = 0;
    for (std::uint32_t q = 1U << (bits - 1); q > 1; q >>= 1)
        if (axes[2] & q) gray ^= q - 1;
    for (std::uint32_t& axis : axes) axis ^= gray;
}

} // namespace

std::uint64_t hilbert_key(Vec3d unit) {
    Axes axes = quantise(unit);
    to_transposed(axes);
    std::uint64_t key = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
        for (const std::uint32_t axis : axes) key = key << 1 | (axis >> bit & 1U);
    return key;
}

} // namespace ciel::detail
