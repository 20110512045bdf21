#include "extraction/classify_vertices.hpp"

#include "parallel/vector_units.hpp"

#include <algorithm>

namespace ciel::detail {

// Vectorized, because this loop visits every vertex of a block.
CIEL_FOR_ALL_VECTOR_UNITS void mark_high(const float* values, std::size_t count, float threshold, std::uint8_t* high) {
    for (std::size_t v = 0; v < count; ++v) high[v] = values[v] >= threshold ? 1 : 0;
}

CIEL_FOR_ALL_VECTOR_UNITS void mark_high(const double* values, std::size_t count, double threshold,
                                         std::uint8_t* high) {
    for (std::size_t v = 0; v < count; ++v) high[v] = values[v] >= threshold ? 1 : 0;
}

const std::uint8_t* mark_vertices(ValuesView values, double threshold, CutScratch& scratch) {
    const std::size_t padded = (values.size() + 63) / 64 * 64;
    if (const std::size_t room = std::max(padded, local_ids); scratch.high.size() < room) scratch.high.resize(room);
    std::uint8_t* high = scratch.high.data();
    values.with([&](const auto& all) {
        using Value = std::ranges::range_value_t<decltype(all)>;
        mark_high(all.data(), all.size(), static_cast<Value>(threshold), high);
    });
    std::fill(high + values.size(), high + padded, std::uint8_t{0});
    return high;
}

bool classify(ValuesView values, double threshold, CutScratch& scratch, ActiveBlock& cut) {
    const std::uint8_t* high = mark_vertices(values, threshold, scratch);
    const std::size_t words = (values.size() + 63) / 64;
    bool same = cut.known;
    cut.signature.resize(words);
    for (std::size_t w = 0; w < words; ++w) {
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < 8; ++i) bits |= bits_of(high + 64 * w + 8 * i) << 8 * i;
        same = same && cut.signature[w] == bits;
        cut.signature[w] = bits;
    }
    return same;
}

} // namespace ciel::detail
