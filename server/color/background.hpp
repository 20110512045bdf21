// Colors of a picture's background, and whether text on it is dark. The web page runs the same code (server/page).
#pragma once

#include <array>

namespace server::color {

struct Background { // a gradient; RGB, 0 to 1
    std::array<float, 3> top{}, bottom{};
};

inline constexpr Background dark_background{{0.10F, 0.12F, 0.16F}, {0.03F, 0.04F, 0.05F}};
inline constexpr Background light_background{{1.0F, 1.0F, 1.0F}, {0.90F, 0.92F, 0.95F}};

// Returns true if dark text has more contrast than light text in the middle of the gradient.
[[nodiscard]] bool is_bright(const Background& background);

} // namespace server::color
