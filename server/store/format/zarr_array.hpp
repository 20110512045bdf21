// Reads and writes .zarray documents of Zarr version 2 for arrays that the store can map: C order, little endian, no
// compressor, no filters, "." between chunk indices. Format: https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace server::store {

enum class ElementType { u1, u4, u8, i8, f4, f8 };
[[nodiscard]] std::size_t element_bytes(ElementType type);

struct ZarrArray {
    ElementType type = ElementType::f4;
    std::vector<std::uint64_t> shape;
    std::vector<std::uint64_t> chunks; // extents of one chunk; as many entries as `shape`; no entry is 0

    // Returns 0 for an empty array. Throws Error that names `file` when the size exceeds 2^63 - 1 bytes.
    [[nodiscard]] std::size_t chunk_bytes(const std::filesystem::path& file) const;
};

[[nodiscard]] ZarrArray whole_array(ElementType type, std::uint64_t count);

// Throws Error that names `file` when `text` is not valid, or describes an array that the store cannot map.
[[nodiscard]] ZarrArray parse_zarr_array(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const ZarrArray& array);

[[nodiscard]] std::string group_text(); // the content of .zgroup
void check_group_text(std::string_view text, const std::filesystem::path& file);

} // namespace server::store
