// Reads NumPy's .npy files that hold float arrays in C order.
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

// Reads an array of float32, or of float64, which is converted to float32. Throws Error that names `file` unless the
// array is little-endian, in C order and of one or two dimensions, and its size fits its shape.
[[nodiscard]] NpyArray parse_npy(std::span<const std::byte> bytes, const std::filesystem::path& file);
[[nodiscard]] NpyArray read_npy(const std::filesystem::path& file);

} // namespace ciel::store
