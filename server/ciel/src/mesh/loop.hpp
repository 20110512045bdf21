// A face's loop without the repeated vertices of collapsed cells: no half-edge joins a vertex to itself. The paper's
// appendix A has no rule for them.
#pragma once

#include "ciel/types.hpp"

#include <vector>

namespace ciel {

// Appends `loop` to `out` without each vertex that equals its successor around the loop. A loop that collapsed to a
// point appends nothing; one that collapsed to a line appends both ends. Returns the number of ids appended. Reads each
// id once, so the result has no repeats even if the loop changes meanwhile.
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

} // namespace ciel
