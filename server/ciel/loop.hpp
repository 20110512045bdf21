// A face's loop without the repeats that collapsed cells bring: no half-edge joins a vertex to itself. What the paper's
// appendix A has no rule for.
#pragma once

#include "ciel/types.hpp"

#include <vector>

namespace ciel {

// Appends `loop` to `out`, leaving out each vertex that equals its successor around the loop. A loop that collapsed to
// a point appends nothing, one that collapsed to a line appends both of its ends. Returns how many were appended. Reads
// each id once, so that what it appends has no repeats even when the loop changes meanwhile.
template <class Loop>
std::size_t append_without_repeats(const Loop& loop, std::vector<Index>& out) {
    const std::size_t before = out.size();
    out.insert(out.end(), loop.begin(), loop.end());
    if (out.size() == before) return 0;
    const Index first = out[before];
    std::size_t kept = before;
    for (std::size_t i = before; i < out.size(); ++i)
        if (out[i] != (i + 1 == out.size() ? first : out[i + 1])) out[kept++] = out[i];
    out.resize(kept);
    return kept - before;
}

} // namespace ciel
