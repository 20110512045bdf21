#include "store/format/value_ranges.hpp"

#include "store/format/byte_arrays.hpp"

namespace ciel::store {
namespace {

// Follows the head of the file. Offsets count from the begin of the file; 0: the file has no such array.
struct RangesHead {
    std::uint64_t blocks = 0, scalars = 0;
    std::uint64_t chunk_checksum = 0;
    std::array<char, 8> type{'<', 'f', '4'};
    std::uint64_t low = 0, high = 0, missing = 0;
    std::array<std::uint64_t, 2> reserved{}; // offsets of a histogram and of checksums by 64 KiB
};
static_assert(sizeof(RangesHead) == 72);

} // namespace

std::vector<std::byte> to_bytes(const ValueRanges& ranges, const std::string& dataset_id,
                                std::uint64_t chunk_checksum) {
    RangesHead head;
    head.blocks = ranges.empty() ? 0 : ranges[0].low.size();
    head.scalars = ranges.size();
    head.chunk_checksum = chunk_checksum;
    head.low = file_head_bytes + sizeof head;
    head.high = head.low + head.scalars * head.blocks * sizeof(float);
    head.missing = head.high + head.scalars * head.blocks * sizeof(float);
    ByteWriter out(FileKind::ranges, dataset_id);
    out.add(head);
    for (const BlockRanges& of : ranges) out.add(std::span<const float>(of.low));
    for (const BlockRanges& of : ranges) out.add(std::span<const float>(of.high));
    for (const BlockRanges& of : ranges) out.add(std::span<const std::uint32_t>(of.missing));
    return out.finish();
}

std::optional<ValueRanges> parse_value_ranges(std::span<const std::byte> bytes, const std::string& dataset_id,
                                              std::size_t scalars, std::size_t blocks, std::uint64_t chunk_checksum,
                                              const std::filesystem::path& file) {
    const ByteReader read(bytes, FileKind::ranges, dataset_id, file);
    const RangesHead head = read.array<RangesHead>(file_head_bytes, 1).front();
    if (head.type != RangesHead{}.type) read.refuse_unknown("a type of numbers");
    if (head.blocks != blocks || head.scalars != scalars) read.refuse_damage("belongs to another array");
    if (head.chunk_checksum != chunk_checksum) return std::nullopt;
    ValueRanges ranges(scalars);
    for (std::size_t i = 0; i < scalars; ++i) {
        ranges[i].low = read.array<float>(head.low + i * blocks * sizeof(float), blocks);
        ranges[i].high = read.array<float>(head.high + i * blocks * sizeof(float), blocks);
        ranges[i].missing = read.array<std::uint32_t>(head.missing + i * blocks * sizeof(float), blocks);
    }
    return ranges;
}

} // namespace ciel::store
