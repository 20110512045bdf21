// Removes repeated consecutive vertices from the loop of a face, so that no half-edge joins a vertex to itself.
// Collapsed cells have such repeats, for which the paper's appendix A has no rule.
#pragma once

#include "ciel/types.hpp"

#include <span>
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

enum class Relation { different, same_direction, opposite };

// Compares two loops without repeats. They may start at different vertices.
[[nodiscard]] inline Relation compare_loops(std::span<const Index> a, std::span<const Index> b) {
    const std::size_t n = a.size();
    if (n != b.size()) return Relation::different;
    for (std::size_t shift = 0; shift < n; ++shift) {
        if (b[shift] != a[0]) continue;
        bool forward = true, backward = true;
        for (std::size_t i = 0; i < n && (forward || backward); ++i) {
            forward = forward && a[i] == b[(shift + i) % n];
            backward = backward && a[i] == b[(shift + n - i) % n];
        }
        if (backward) return Relation::opposite;
        if (forward) return Relation::same_direction;
    }
    return Relation::different;
}

} // namespace ciel::detail
