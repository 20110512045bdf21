// Names and paths of the files inside NAME.ciel (format: store/README.md).
#pragma once

#include "ciel/record_source.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ciel::store::layout {

inline constexpr int format_version = 2;
inline constexpr std::uint16_t records_version = 2; // of all binary files (file_head.hpp)
inline constexpr const char* commit_marker = "steps.json";
inline constexpr const char* step_table = "steps"; // a folder
inline constexpr const char* group_document = ".zgroup";
inline constexpr const char* attributes_document = ".zattrs";
inline constexpr const char* array_document = ".zarray";

// Largest accepted sizes of the text files, in bytes. They protect against damaged and hostile files.
inline constexpr std::size_t document_bytes = std::size_t{1} << 24;
inline constexpr std::size_t marker_bytes = std::size_t{1} << 28;
inline constexpr std::size_t ranges_bytes = std::size_t{1} << 32;
inline constexpr std::size_t index_bytes = std::size_t{1} << 32;

[[nodiscard]] std::filesystem::path mesh(const std::filesystem::path& dataset, std::size_t mesh);
[[nodiscard]] std::filesystem::path face_or_cell_group(const std::filesystem::path& mesh, std::size_t index);
[[nodiscard]] std::filesystem::path values(const std::filesystem::path& mesh, const std::string& array);
// Returns the file of chunk `first` of an array of `rank` dimensions that is divided along the first one only: for rank
// 3, "<first>.0.0".
[[nodiscard]] std::filesystem::path chunk(const std::filesystem::path& array, std::uint64_t first, std::size_t rank);

// Returns the file with the ranges of one chunk of an array. `array`: the directory of the array.
[[nodiscard]] std::filesystem::path value_ranges(const std::filesystem::path& array, std::uint64_t chunk);

// Returns the directory name of an array: each byte but A-Z a-z 0-9 _ - becomes %XX. A long name is truncated and ends
// in its hash.
[[nodiscard]] std::string encode_name(const std::string& name);

// Return the index of a mesh's blocks, and file `number` of the records of one kind.
[[nodiscard]] std::filesystem::path block_index(const std::filesystem::path& mesh);
[[nodiscard]] std::filesystem::path records(const std::filesystem::path& mesh, RecordKind kind, std::size_t number);

// Topology arrays that every mesh has. Each is one chunk.
inline constexpr const char* whole_arrays[] = {"cell_types", "original_vertex", "original_cell"};

// The arrays of the numbered faces, in a folder; in format 1, those of all faces, without the folder.
inline constexpr const char* faces_group = "faces";
inline constexpr const char* face_arrays[] = {"face_offset", "face_vertex", "owner", "neighbour"};

// Arrays of ids that are no indices, with the checksums of their pages.
inline constexpr const char* id_arrays[] = {"original_vertex", "original_cell", "solver_vertex", "solver_cell"};

// Arrays of solver ids, which a mesh has only if its source has them. Each is one chunk.
inline constexpr const char* optional_arrays[] = {"solver_vertex", "solver_cell"};

} // namespace ciel::store::layout
