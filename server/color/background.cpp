#include "color/background.hpp"

#include <cstddef>

namespace server::color {
namespace {

constexpr float middle_gray = 0.46F; // luma on which light and dark text have equal contrast
constexpr std::array<float, 3> luma_weights{0.2126F, 0.7152F, 0.0722F};

} // namespace

bool is_bright(const Background& background) {
    float luma = 0;
    for (std::size_t i = 0; i < luma_weights.size(); ++i)
        luma += luma_weights[i] * (background.top[i] + background.bottom[i]) / 2;
    return luma > middle_gray;
}

} // namespace server::color
