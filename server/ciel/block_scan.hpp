// The cut of one block from its values alone: every edge is looked at. What SignatureCutter does where a classification
// has changed, and NaiveCutter always.
#pragma once

#include "ciel/cut_block.hpp"

namespace ciel {

[[nodiscard]] CutScratch& scratch_of_this_thread();

// Classifies into bytes and bits; true when the bits are the ones the cut was made for. (Bits do not tell a vertex
// without a value from a low one: the caller never trusts them where there are such.)
bool classify(std::span<const float> values, float threshold, CutScratch& scratch, CutBlock& cut);

// Active edges, entries and polygons, after `classify` with the same scratch. `gaps`: some vertex has no value.
void cut_classified(const Block& block, std::span<const float> values, bool gaps, CutScratch& scratch, CutBlock& cut);

} // namespace ciel
