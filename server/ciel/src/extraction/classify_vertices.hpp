// Classifies the vertices of a block: high if the value is at least the threshold, else low (paper, section 2.1). The
// bits of all vertices are the block's signature.
#pragma once

#include "extraction/cut_block.hpp"

#include <cstring>

namespace ciel::detail {

// Sets high[i] to 1 if values[i] >= threshold, else to 0. `high` must not overlap `values`.
void mark_high(const float* values, std::size_t count, float threshold, std::uint8_t* high);
void mark_high(const double* values, std::size_t count, double threshold, std::uint8_t* high);
// Sets scratch.high and returns it. The entries after the last vertex, up to a multiple of 64, are 0.
const std::uint8_t* mark_vertices(ValuesView values, double threshold, CutScratch& scratch);
// Sets scratch.high and cut.signature. Returns true if the cut is known and has the same signature, so that it can be
// kept. In blocks with gaps, ignore the result, because vertices without a value count as low.
bool classify(ValuesView values, double threshold, CutScratch& scratch, ActiveBlock& cut);

// Packs eight bytes, each 0 or 1, into eight bits: the multiplication moves byte i to bit i of the top byte.
inline std::uint64_t bits_of(const std::uint8_t* bytes) {
    std::uint64_t word;
    std::memcpy(&word, bytes, sizeof word);
    return word * 0x0102040810204080U >> 56;
}

} // namespace ciel::detail
