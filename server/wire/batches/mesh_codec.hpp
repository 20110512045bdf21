// meshoptimizer's codecs in the versions that protocol/frame.md requires: vertices 0xA0, triangles 0xE1, sequences
// 0xD1. The glTF extension EXT_meshopt_compression describes the bitstreams.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel::wire {

// Appends `vertices` in compressed form: records of `stride` bytes (a multiple of 4, at most 256). Adjacent records
// that are similar compress well. Returns the number of bytes appended.
std::size_t append_vertices(std::vector<std::uint8_t>& out, std::span<const std::uint8_t> vertices, std::size_t stride);
// Appends three indices per triangle, each below `vertices`, in compressed form. Decoding keeps the order of the
// triangles, but can rotate their corners. Returns the number of bytes appended.
std::size_t append_triangles(std::vector<std::uint8_t>& out, std::span<const Index> indices, std::size_t vertices);
// Appends indices of lines or points, each below `vertices`, in compressed form. Decoding returns the same indices in
// the same order. Returns the number of bytes appended.
std::size_t append_sequence(std::vector<std::uint8_t>& out, std::span<const Index> indices, std::size_t vertices);

} // namespace ciel::wire
