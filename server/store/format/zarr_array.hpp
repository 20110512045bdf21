// The .zarray document of Zarr version 2, as far as the store uses it: C order, little endian, no compressor, no
// filters, "." between chunk indices. Format: https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::store {

enum class ElementType { u1, u4, u8, i8, f4 };
[[nodiscard]] std::size_t element_bytes(ElementType type);

struct ZarrArray {
    ElementType type = ElementType::f4;
    std::vector<std::uint64_t> shape;
    std::vector<std::uint64_t> chunks; // same rank, none zero

    // Throws Error naming `file` when the bytes do not fit into memory.
    [[nodiscard]] std::size_t chunk_bytes(const std::filesystem::path& file) const;
};

// One chunk that holds everything.
[[nodiscard]] ZarrArray whole_array(ElementType type, std::uint64_t count);

// Throws Error naming `file` for anything but what the store can map.
[[nodiscard]] ZarrArray parse_zarr_array(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const ZarrArray& array);

[[nodiscard]] std::string group_text(); // the content of .zgroup
void check_group_text(std::string_view text, const std::filesystem::path& file);

} // namespace ciel::store
