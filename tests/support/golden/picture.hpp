// Pictures in memory, and as PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ciel::test {

// Rows from the top, RGB, 8 bits of sRGB per channel, no padding.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

// Throws std::runtime_error that names the file.
[[nodiscard]] Picture read_png(const std::filesystem::path& file);
void write_png(const std::filesystem::path& file, const Picture& picture); // creates the folder

} // namespace ciel::test
