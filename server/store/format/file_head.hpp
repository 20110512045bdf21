// The first 64 bytes of each binary file of a dataset: what it is, the versions of its format, and the dataset's id,
// which tells files of two datasets apart (store/README.md, "Blocks").
#pragma once

#include "ciel/record_source.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace ciel::store {

// Four characters. The files of records have the kinds of their records (RecordKind).
enum class FileKind : std::uint32_t {
    index = 0x78646e69,       // "indx"
    ranges = 0x676e6172,      // "rang"
    step_rows = 0x77727473,   // "strw"
    step_arrays = 0x72617473, // "star"
};
[[nodiscard]] inline FileKind file_kind(RecordKind kind) { return static_cast<FileKind>(kind); }

inline constexpr std::size_t file_head_bytes = 64;

[[nodiscard]] std::array<std::byte, file_head_bytes> file_head(FileKind kind, const std::string& dataset_id);
// Throws Error that names the file when its first bytes are damaged, of another kind or dataset, or of a newer format.
void check_file_head(std::span<const std::byte> bytes, FileKind kind, const std::string& dataset_id,
                     const std::filesystem::path& file);

} // namespace ciel::store
