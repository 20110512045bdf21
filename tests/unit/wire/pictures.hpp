// Test pictures for the codecs: content like that of frames, and incompressible noise.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace server::wire {

struct Picture {
    std::string name;
    int width, height;
    std::vector<std::uint8_t> rgb;
};

inline std::vector<Picture> pictures() {
    std::vector<Picture> all{{"one pixel", 1, 1, {1, 2, 3}}};
    std::mt19937 random(7);
    const auto add = [&](const char* name, int width, int height, auto color) {
        Picture picture{name, width, height, {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int k = 0; k < 3; ++k) picture.rgb.push_back(static_cast<std::uint8_t>(color(x, y, k)));
        all.push_back(std::move(picture));
    };
    add("noise", 97, 61, [&](int, int, int) { return random() & 255U; });
    add("black", 640, 480, [](int, int, int) { return 0; });
    add("gradient", 333, 200, [](int, int y, int k) { return 40 - y / 5 + 4 * k; });
    add("ball", 320, 240, [](int x, int y, int k) {
        const double r = std::hypot(x - 160, y - 120) / 100;
        return r < 1 ? 80.0 + 150 * std::sqrt(1 - r * r) + 5 * k : 20.0;
    });
    add("tall", 1, 500, [](int, int y, int k) { return y * 3 + k; });
    return all;
}

} // namespace server::wire
