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
    const std::size_t before = out.size(), size = loop.size();
    if (size == 0) return 0;
    const Index first = loop[0];
    Index last = first;
    out.push_back(first);
    for (std::size_t i = 1; i < size; ++i) {
        const Index id = loop[i];
        if (id != last) out.push_back(id);
        last = id;
    }
    if (last == first) out.pop_back(); // the only one, or the loop's end
    return out.size() - before;
}

} // namespace ciel
