// Reads NumPy's .npy files that hold arrays of floats or doubles in C order.
// Format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include "store/format/values.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace server::store {

struct NpyArray {
    std::vector<std::size_t> shape; // one or two entries
    Values values;
};

// Throws Error that names `file` unless the array is float32 or float64, little-endian, and has one or two dimensions.
[[nodiscard]] NpyArray parse_npy(std::span<const std::byte> bytes, const std::filesystem::path& file);
[[nodiscard]] NpyArray read_npy(const std::filesystem::path& file);

} // namespace server::store
