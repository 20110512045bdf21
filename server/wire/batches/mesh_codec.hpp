// meshoptimizer's codecs in the versions that protocol/frame.md requires: vertices 0xA0, triangles 0xE1, sequences
// 0xD1. The glTF extension EXT_meshopt_compression describes the bitstreams.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace server::wire {

// Encodes vertex records. `stride`: bytes of a record, a multiple of 4, at most 256. Like the functions below, returns
// the number of bytes appended to `out`.
std::size_t append_vertices(std::vector<std::uint8_t>& out, std::span<const std::uint8_t> vertices, std::size_t stride);
// Encodes triangles. Indices must be below `vertices`. Decoding keeps the order of the triangles, but can rotate their
// corners.
std::size_t append_triangles(std::vector<std::uint8_t>& out, std::span<const ciel::Index> indices,
                             std::size_t vertices);
// Encodes the indices of lines or points, which must be below `vertices`. Decoding returns the indices in the same
// order.
std::size_t append_sequence(std::vector<std::uint8_t>& out, std::span<const ciel::Index> indices, std::size_t vertices);

} // namespace server::wire
