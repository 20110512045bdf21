// The head: the first 64 bytes of each binary file of a dataset. With the dataset's id in the head, a reader detects a
// file of another dataset. Bytes: store/README.md, "Blocks".
#pragma once

#include "ciel/record_source.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace server::store {

// The kind of a file, four characters. A file of records has the kind of its records (RecordKind).
enum class FileKind : std::uint32_t {
    index = 0x78646e69,       // "indx"
    ranges = 0x676e6172,      // "rang"
    step_rows = 0x77727473,   // "strw"
    step_arrays = 0x72617473, // "star"
};
[[nodiscard]] inline FileKind file_kind(ciel::RecordKind kind) { return static_cast<FileKind>(kind); }

inline constexpr std::size_t file_head_bytes = 64;

[[nodiscard]] std::array<std::byte, file_head_bytes> file_head(FileKind kind, const std::string& dataset_id);
// Throws Error that names the file when its head is damaged or of another kind, another dataset or a newer format.
void check_file_head(std::span<const std::byte> bytes, FileKind kind, const std::string& dataset_id,
                     const std::filesystem::path& file);

} // namespace server::store
