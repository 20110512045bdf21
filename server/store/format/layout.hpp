// Where everything lies inside NAME.ciel (store/README.md is the whole format).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ciel::store::layout {

inline constexpr int format_version = 1;
inline constexpr const char* commit_marker = "steps.json";
inline constexpr const char* group_document = ".zgroup";
inline constexpr const char* attributes_document = ".zattrs";
inline constexpr const char* array_document = ".zarray";

// Limits on the text files, against a damaged or hostile size.
inline constexpr std::size_t document_bytes = std::size_t{1} << 24;
inline constexpr std::size_t marker_bytes = std::size_t{1} << 28;

[[nodiscard]] std::filesystem::path mesh(const std::filesystem::path& dataset, std::size_t mesh);
[[nodiscard]] std::filesystem::path face_or_cell_group(const std::filesystem::path& mesh, std::size_t index);
[[nodiscard]] std::filesystem::path values(const std::filesystem::path& mesh, const std::string& array);
// The file of one chunk: "first.0.0" for an array of `rank` dimensions that is cut along its first.
[[nodiscard]] std::filesystem::path chunk(const std::filesystem::path& array, std::uint64_t first, std::size_t rank);

// An array's name as a directory: everything but A-Z a-z 0-9 _ - becomes %XX; a long one is cut and ends in its hash.
[[nodiscard]] std::string encode_name(const std::string& name);

// The topology arrays of a mesh that are one chunk each.
inline constexpr const char* whole_arrays[] = {"cell_types", "face_offset",     "face_vertex",  "owner",
                                               "neighbour",  "original_vertex", "original_cell"};

// Those that a source may not have.
inline constexpr const char* optional_arrays[] = {"solver_vertex", "solver_cell"};

} // namespace ciel::store::layout
