#include "store/format/value_ranges.hpp"

#include "store/format/byte_arrays.hpp"

#include <algorithm>
#include <cmath>

namespace server::store {
namespace {

// The bytes after the common file head. Offsets are in bytes from the beginning of the file. 0: the array is absent.
struct RangesHead {
    std::uint64_t blocks = 0, scalars = 0;
    std::uint64_t chunk_checksum = 0;
    std::array<char, 8> type{}; // number type of the limits: floats_type or doubles_type
    std::uint64_t low = 0, high = 0, missing = 0;
    std::uint64_t histograms = 0;
    std::uint64_t stretch_checksums = 0;
};
static_assert(sizeof(RangesHead) == 72);

struct StoredHistogram {
    std::array<double, 2> range{};
    std::uint64_t invalid = 0;
    std::array<std::uint64_t, stored_bins> counts{};
};
static_assert(sizeof(StoredHistogram) == 2072);

constexpr std::array<char, 8> floats_type{'<', 'f', '4'}, doubles_type{'<', 'f', '8'};

bool is_float(double limit) { return static_cast<float>(limit) == limit; }
bool are_floats(const ciel::BlockRanges& ranges) {
    return std::ranges::all_of(ranges.low, is_float) && std::ranges::all_of(ranges.high, is_float);
}

void add_limits(ByteWriter& out, const std::vector<double>& limits, bool floats) {
    if (floats)
        out.add(std::span<const float>(std::vector<float>(limits.begin(), limits.end())));
    else
        out.add(std::span(limits));
}

std::vector<StoredHistogram> to_stored(const std::vector<Histogram>& histograms) {
    std::vector<StoredHistogram> stored;
    for (const Histogram& histogram : histograms) {
        StoredHistogram& row = stored.emplace_back();
        row.range = histogram.range;
        row.invalid = histogram.invalid;
        std::ranges::copy(histogram.counts, row.counts.begin());
    }
    return stored;
}

std::vector<Histogram> read_histograms(const ByteReader& read, std::uint64_t begin, std::size_t count) {
    std::vector<Histogram> histograms;
    for (const StoredHistogram& row : read.array<StoredHistogram>(begin, count)) {
        if (!std::isfinite(row.range[0]) || !std::isfinite(row.range[1]) || row.range[0] > row.range[1])
            read.refuse_damage("has a histogram whose range is not valid");
        Histogram& histogram = histograms.emplace_back(row.range, stored_bins);
        histogram.invalid = row.invalid;
        std::ranges::copy(row.counts, histogram.counts.begin());
    }
    return histograms;
}

// Refuses NaN, because blocks are sorted by their limits.
std::vector<double> read_limits(const ByteReader& read, std::uint64_t begin, std::size_t count, bool floats) {
    std::vector<double> limits;
    if (floats) {
        const std::vector<float> stored = read.array<float>(begin, count);
        limits.assign(stored.begin(), stored.end());
    } else {
        limits = read.array<double>(begin, count);
    }
    if (std::ranges::any_of(limits, [](double limit) { return std::isnan(limit); }))
        read.refuse_damage("has a minimum or maximum that is NaN");
    return limits;
}

} // namespace

std::vector<std::byte> to_bytes(const ValueRanges& ranges, const std::string& dataset_id,
                                std::uint64_t chunk_checksum) {
    RangesHead head;
    const std::vector<ciel::BlockRanges>& scalars = ranges.scalars;
    head.blocks = scalars.empty() ? 0 : scalars[0].low.size();
    head.scalars = scalars.size();
    head.chunk_checksum = chunk_checksum;
    const bool floats = std::ranges::all_of(scalars, are_floats);
    head.type = floats ? floats_type : doubles_type;
    const std::uint64_t limits_bytes = head.scalars * head.blocks * (floats ? sizeof(float) : sizeof(double));
    head.low = file_head_bytes + sizeof head;
    head.high = head.low + limits_bytes;
    head.missing = head.high + limits_bytes;
    const std::uint64_t missing_words = head.scalars * head.blocks, padding_words = missing_words % 2;
    const std::vector<StoredHistogram> histograms = to_stored(ranges.histograms);
    const std::uint64_t after_missing = head.missing + (missing_words + padding_words) * sizeof(std::uint32_t);
    if (!histograms.empty()) head.histograms = after_missing;
    head.stretch_checksums = after_missing + histograms.size() * sizeof(StoredHistogram);
    ByteWriter out(FileKind::ranges, dataset_id);
    out.add(head);
    for (const ciel::BlockRanges& of : scalars) add_limits(out, of.low, floats);
    for (const ciel::BlockRanges& of : scalars) add_limits(out, of.high, floats);
    for (const ciel::BlockRanges& of : scalars) out.add(std::span<const std::uint32_t>(of.missing));
    if (padding_words > 0) out.add(std::uint32_t{0});
    out.add(std::span<const StoredHistogram>(histograms));
    out.add(std::span<const std::uint64_t>(ranges.stretch_checksums));
    return out.finish();
}

std::optional<ValueRanges> parse_value_ranges(std::span<const std::byte> bytes, const std::string& dataset_id,
                                              std::size_t scalars, std::size_t blocks, std::size_t chunk_bytes,
                                              std::uint64_t chunk_checksum, const std::filesystem::path& file) {
    const ByteReader read(bytes, FileKind::ranges, dataset_id, file);
    const RangesHead head = read.array<RangesHead>(file_head_bytes, 1).front();
    const bool floats = head.type == floats_type;
    if (!floats && head.type != doubles_type) read.refuse_unknown("a type of numbers");
    if (head.blocks != blocks || head.scalars != scalars) read.refuse_damage("belongs to another array");
    if (head.chunk_checksum != chunk_checksum) return std::nullopt;
    ValueRanges ranges;
    for (std::size_t i = 0; i < scalars; ++i) {
        const std::uint64_t before = i * blocks * (floats ? sizeof(float) : sizeof(double));
        ranges.scalars.push_back(
            {read_limits(read, head.low + before, blocks, floats),
             read_limits(read, head.high + before, blocks, floats),
             read.array<std::uint32_t>(head.missing + i * blocks * sizeof(std::uint32_t), blocks)});
    }
    if (head.histograms != 0) ranges.histograms = read_histograms(read, head.histograms, scalars);
    const std::size_t stretches = (chunk_bytes + stretch_bytes - 1) / stretch_bytes;
    if (head.stretch_checksums != 0)
        ranges.stretch_checksums = read.array<std::uint64_t>(head.stretch_checksums, stretches);
    return ranges;
}

} // namespace server::store
