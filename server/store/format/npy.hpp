// NumPy's .npy files, as far as float arrays in C order go.
// Format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace ciel::store {

struct NpyArray {
    std::vector<std::size_t> shape; // one or two extents
    std::vector<float> values;
};

// float64 is narrowed. Throws Error naming `file` for anything else than little-endian float32 or float64 in C order of
// one or two dimensions, and when the size does not fit the shape.
[[nodiscard]] NpyArray parse_npy(std::span<const std::byte> bytes, const std::filesystem::path& file);
[[nodiscard]] NpyArray read_npy(const std::filesystem::path& file);

} // namespace ciel::store
