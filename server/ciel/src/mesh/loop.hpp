// Removes repeated consecutive vertices from the loop of a face, so that no half-edge joins a vertex to itself.
// Collapsed cells have such repeats, for which the paper's appendix A has no rule.
#pragma once

#include "ciel/types.hpp"

#include <vector>

namespace ciel::detail {

// Leaves out repeats, also between the last and the first vertex. Appends nothing if the loop has collapsed to a point.
// Returns the number of ids appended. Reads each id once, because `loop` may be in a mapped file that changes.
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
    if (last == first) out.pop_back(); // a single vertex, or the end equals the start
    return out.size() - before;
}

} // namespace ciel::detail
