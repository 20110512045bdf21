// ValueRanges: the file beside a chunk of an array. With its [min, max] in each block, an iso-surface reads only the
// blocks that it crosses. Bytes: store/README.md, "Ranges".
#pragma once

#include "ciel/block_ranges.hpp"
#include "store/format/histogram.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace server::store {

struct ValueRanges {
    // The first two vectors have an entry for the magnitude, if the array has a magnitude, then one for each component.
    std::vector<ciel::BlockRanges> scalars;       // without blocks if the array is not on points
    std::vector<Histogram> histograms;            // with stored_bins bins; empty if the file has none
    std::vector<std::uint64_t> stretch_checksums; // of the chunk (checksum.hpp); empty if the file has none
};

[[nodiscard]] std::vector<std::byte> to_bytes(const ValueRanges& ranges, const std::string& dataset_id,
                                              std::uint64_t chunk_checksum);
// Returns nullopt if the ranges were written for a chunk with another checksum. Throws Error that names `file` when the
// bytes are damaged, are of another dataset, or have other numbers of scalars or blocks.
[[nodiscard]] std::optional<ValueRanges> parse_value_ranges(std::span<const std::byte> bytes,
                                                            const std::string& dataset_id, std::size_t scalars,
                                                            std::size_t blocks, std::size_t chunk_bytes,
                                                            std::uint64_t chunk_checksum,
                                                            const std::filesystem::path& file);

} // namespace server::store
