// What is stored beside the values of an array at one step: [min, max] in each block of the mesh, histograms, checksums
// of pages. With them an iso-surface opens the blocks that it crosses, and no other. Bytes: store/README.md, "Ranges".
#pragma once

#include "ciel/block_ranges.hpp"
#include "store/format/histogram.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ciel::store {

struct ValueRanges {
    // Of the magnitude if the array has one, then of each component:
    std::vector<BlockRanges> scalars;          // of no blocks if the array is not on points
    std::vector<Histogram> histograms;         // with stored_bins; empty if none are stored
    std::vector<std::uint64_t> page_checksums; // of the chunk (checksum.hpp); empty if none are stored
};

[[nodiscard]] std::vector<std::byte> to_bytes(const ValueRanges& ranges, const std::string& dataset_id,
                                              std::uint64_t chunk_checksum);
// Returns nullopt when the ranges belong to another chunk than the one with the checksum `chunk_checksum`. Throws Error
// that names `file` when the bytes are damaged, of another dataset, or of other numbers of blocks or scalars.
// `chunk_bytes`: size of the chunk.
[[nodiscard]] std::optional<ValueRanges> parse_value_ranges(std::span<const std::byte> bytes,
                                                            const std::string& dataset_id, std::size_t scalars,
                                                            std::size_t blocks, std::size_t chunk_bytes,
                                                            std::uint64_t chunk_checksum,
                                                            const std::filesystem::path& file);

} // namespace ciel::store
