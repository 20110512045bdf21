// Names and paths of the files inside NAME.ciel (format: store/README.md).
#pragma once

#include "ciel/record_source.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace server::store::layout {

inline constexpr int format_version = 2;
inline constexpr std::uint16_t records_version = 2; // format version of all binary files (file_head.hpp)
inline constexpr const char* commit_marker = "steps.json";
inline constexpr const char* step_table = "steps"; // name of the folder that has the table of steps
inline constexpr const char* group_document = ".zgroup";
inline constexpr const char* attributes_document = ".zattrs";
inline constexpr const char* array_document = ".zarray";

// Largest accepted sizes of files that are read as a whole, in bytes: protection against hostile files.
inline constexpr std::size_t document_bytes = std::size_t{1} << 24;
inline constexpr std::size_t marker_bytes = std::size_t{1} << 28;
inline constexpr std::size_t ranges_bytes = std::size_t{1} << 32;
inline constexpr std::size_t index_bytes = std::size_t{1} << 32;

[[nodiscard]] std::filesystem::path mesh(const std::filesystem::path& dataset, std::size_t mesh);
[[nodiscard]] std::filesystem::path face_or_cell_group(const std::filesystem::path& mesh, std::size_t index);
[[nodiscard]] std::filesystem::path values(const std::filesystem::path& mesh, const std::string& array);
// `first`: index of the chunk in the first dimension. In all other dimensions, the array has only one chunk. For rank
// 3, the file name is "<first>.0.0".
[[nodiscard]] std::filesystem::path chunk(const std::filesystem::path& array, std::uint64_t first, std::size_t rank);

// Path of the checksum and the ranges of a late chunk (late_files.hpp), which are not in the marker.
[[nodiscard]] std::filesystem::path late_facts(const std::filesystem::path& array, std::uint64_t chunk);
inline constexpr const char* late_changes = "late"; // name of a file that every writer of late arrays replaces

[[nodiscard]] std::filesystem::path value_ranges(const std::filesystem::path& array, std::uint64_t chunk);

// Returns the name of the directory of an array. Each byte except A-Z a-z 0-9 _ - becomes %XX (hexadecimal). If the
// result is too long, it is truncated and ends with the hash of `name`.
[[nodiscard]] std::string encode_name(const std::string& name);

[[nodiscard]] std::filesystem::path block_index(const std::filesystem::path& mesh);
[[nodiscard]] std::filesystem::path records(const std::filesystem::path& mesh, ciel::RecordKind kind,
                                            std::size_t number);

// Topology arrays that every mesh has. Each array is one chunk.
inline constexpr const char* whole_arrays[] = {"cell_types", "original_vertex", "original_cell"};

// The arrays `face_arrays` of the numbered faces are in the folder `faces_group`. In format 1, these arrays have all
// faces and are not in a folder.
inline constexpr const char* faces_group = "faces";
inline constexpr const char* face_arrays[] = {"face_offset", "face_vertex", "owner", "neighbour"};

// These ids are not used as indices. The checksums of the arrays' stretches are stored beside the arrays.
inline constexpr const char* id_arrays[] = {"original_vertex", "original_cell", "solver_vertex", "solver_cell"};

// A mesh has such an array only if the imported file has these ids. Each array is one chunk.
inline constexpr const char* optional_arrays[] = {"solver_vertex", "solver_cell"};

} // namespace server::store::layout
